#pragma once

#include <airlight/numeric.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// Irradiance by everything but the sun itself: the sky, and the ground below, without a surface in the way.
template <typename T>
struct SkyIrradiance {
    vec3<T> down;     ///< [1] on a level surface that faces up, per unit of solar irradiance above the air
    vec3<T> up;       ///< [1] on one that faces down: light off the ground and the air below
    vec3<T> sunward;  ///< [1] what more comes through a wall from the sun's side than from behind, over the
                      ///< sun's sine to the vertical
};

/// Irradiance of a surface of any slope by the sky and the ground.
///
///     E(n) = (down (1 + n_z) + up (1 - n_z)) / 2 + sunward (n . sun - n_z mu_s) / 2
///
/// For an open sky: what hides part of it is the caller's, as ambient occlusion.
///
/// Units:    mu_normal and mu_s [1], cosines of the surface's normal and of the sun to the vertical;
///           cos_incidence [1] between normal and sun; result [1] per unit of solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   cosines in [-1, 1] that belong to two unit vectors.
/// Accuracy: exact for surfaces that face up or down, and where radiance is linear in the direction.
/// Errors:   none; never negative.
/// Source:   the first moments of the radiance, as in Ramamoorthi and Hanrahan's spherical harmonics.
template <typename T>
vec3<T> sky_irradiance_on(const SkyIrradiance<T>& sky, T mu_normal, T mu_s, T cos_incidence) {
    const vec3<T> level = T(0.5) * ((T(1) + mu_normal) * sky.down + (T(1) - mu_normal) * sky.up);
    const T lean = cos_incidence - mu_normal * mu_s;
    return glm::max(level + (T(0.5) * lean) * sky.sunward, vec3<T>(T(0), T(0), T(0)));
}

/// The direction that stands for a whole sky: a surface's normal, bent towards the sun.
///
///     E(normal) = pi L(bent),   bent along (1 - bend) normal + bend to_sun
///
/// The sky's irradiance for the price of one look at it, without a table of irradiance. A look at the
/// aureole of a high sun or into the glow of one that has set gives too much.
///
/// Units:    normal and to_sun unit vectors; bend [1], Leenman's is 0.6; result a unit vector.
/// Domain:   bend in [0, 1]: 0 is the normal, 1 the sun.
/// Accuracy: 8 roundoffs of 1, over the length of the sum, which is short where normal and sun are opposite.
///           Level ground under an Earth's sky of all orders, bend 0.6, against a path tracer: 16 % with the
///           sun 10 to 40 degrees high, 46 % while it is up, 80 % too much down to -3 degrees, 2.5 times as
///           much at -6. Without a bend it is 0.36 to 0.74 of the truth. Walls were not measured.
/// Errors:   none; the normal where the sum has no direction, at a bend of a half opposite to the sun.
/// Source:   Leenman, Atmospheric scattering explained (2021), skylight.
template <typename T>
vec3<T> bent_normal(const vec3<T>& normal, const vec3<T>& to_sun, T bend) {
    const vec3<T> bent = (T(1) - bend) * normal + bend * to_sun;
    const T length = glm::sqrt(dot_product(bent, bent));
    if (!(length > T(0))) {
        return normal;
    }
    return bent / length;
}

}  // namespace airlight
