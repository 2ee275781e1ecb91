#pragma once

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

}  // namespace airlight
