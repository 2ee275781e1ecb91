#pragma once

#include <airlight/airlight.hpp>

namespace airlight {

/// Hook: a table of the sun's transmittance, read at texture coordinates with linear filtering and
/// clamping to the edge. The default is no table: everything passes.
struct NoTable {
    template <typename T>
    vec3<T> operator()([[maybe_unused]] const vec2<T>& uv) const {
        return vec3<T>(T(1), T(1), T(1));
    }
};

/// Methods that airlight is compared with, written anew from their descriptions.
namespace baseline {

/// The stretch of a view ray inside the air, in coordinates from the planet's centre.
template <typename T>
struct March {
    bool in_air;    ///< false when no part of the ray is inside the air
    vec3<T> start;  ///< [L] where the stretch begins, from the planet's centre
    T extent;       ///< [L] its length
};

/// The stretch of a view ray that a baseline marches.
///
/// Its ends are those of airlight's air_ray, so that methods differ by their sums alone. Positions
/// count from the planet's centre, as in all the documents, and lose in float what that loses.
///
/// Units:    lengths in the atmosphere's unit [L]; direction a unit vector.
/// Domain:   that of air_ray.
/// Accuracy: in float half a metre in altitude on an Earth.
/// Errors:   none.
/// Source:   air_ray.
template <typename T>
March<T> march_of(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                  T distance) {
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, distance);
    const T eye_radius = atmosphere.ground_radius + glm::max(eye.altitude, T(0));
    return March<T>{ray.in_air, eye_radius * eye.up + ray.begin * direction, ray.extent};
}

/// Altitude of a position that counts from the planet's centre.
///
/// Units:    lengths [L].
/// Domain:   every position.
/// Accuracy: a roundoff of the radius, half a metre in float on an Earth.
/// Errors:   none.
/// Source:   all four documents.
template <typename T>
T altitude_of(const Atmosphere<T>& atmosphere, const vec3<T>& position) {
    return glm::sqrt(dot_product(position, position)) - atmosphere.ground_radius;
}

/// Distance from a position inside a sphere around the planet's centre to its surface.
///
/// Units:    lengths [L]; direction a unit vector.
/// Domain:   a position inside the sphere.
/// Accuracy: textbook roots; half a metre in float on an Earth.
/// Errors:   outside the sphere, on a ray that misses it, the distance to the closest approach.
/// Source:   the quadratic formula, as in all four documents.
template <typename T>
T distance_out(const vec3<T>& position, const vec3<T>& direction, T sphere_radius) {
    const T along = dot_product(position, direction);
    const T outside = dot_product(position, position) - sphere_radius * sphere_radius;
    return safe_sqrt(along * along - outside) - along;
}

/// A column and the air of one more step.
///
/// Units:    column and step_length [L]; density [1].
/// Domain:   all.
/// Accuracy: rounding.
/// Errors:   none.
/// Source:   none.
template <typename T>
Column<T> extended(const Column<T>& column, const Density<T>& density, T step_length) {
    return Column<T>{column.rayleigh + step_length * density.rayleigh, column.mie + step_length * density.mie,
                     column.ozone + step_length * density.ozone};
}

/// Two columns, one after the other.
///
/// Units:    [L].
/// Domain:   all.
/// Accuracy: rounding.
/// Errors:   none.
/// Source:   none.
template <typename T>
Column<T> joined(const Column<T>& a, const Column<T>& b) {
    return Column<T>{a.rayleigh + b.rayleigh, a.mie + b.mie, a.ozone + b.ozone};
}

/// The sums of a march on its way.
template <typename T>
struct Sums {
    Column<T> passed;        ///< [L] between the eye and the end of the last step
    vec3<T> rayleigh_light;  ///< [L] density times transmittance times step
    vec3<T> mie_light;       ///< [L] the same for aerosol
};

/// The sums after one more step: its light is dimmed by half of its own air.
///
/// Units:    towards_sun the column from the sample to the sun [L]; step_length [L]; density [1].
/// Domain:   all.
/// Accuracy: second order in the step.
/// Errors:   none.
/// Source:   midpoint rule.
template <typename T, typename Scene = DefaultScene>
Sums<T> after_step(const Atmosphere<T>& atmosphere, const Sums<T>& sums, const Density<T>& density,
                   const Column<T>& towards_sun, T step_length) {
    const Column<T> to_middle = extended(sums.passed, density, T(0.5) * step_length);
    const vec3<T> share =
        glm::exp(-column_optical_depth<T, Scene>(atmosphere, joined(to_middle, towards_sun)));
    return Sums<T>{extended(sums.passed, density, step_length),
                   sums.rayleigh_light + density.rayleigh * step_length * share,
                   sums.mie_light + density.mie * step_length * share};
}

/// The absorbing layer between a point and the sun, for the methods that have Chapman's function but no
/// formula for such a layer: airlight's own, so that what is left of their error is theirs.
///
/// Units:    radius of the point and result [L]; mu_s [1].
/// Domain:   a point inside the air.
/// Accuracy: that of ozone_to_sun.
/// Errors:   none.
/// Source:   ozone_to_sun.
template <typename T, typename Scene = DefaultScene>
T layer_to_sun(const Atmosphere<T>& atmosphere, const Layers<T>& layers, T radius, T mu_s) {
    T layer = T(0);
    if constexpr (Scene::ozone != ozone_none) {
        const T altitude = radius - atmosphere.ground_radius;
        const LinePoint<T> point = line_towards_sun(altitude, radius, T(1) / radius, radius * mu_s);
        layer = ozone_to_sun<T, Scene>(layers, atmosphere.ground_radius, point, mu_s < T(0));
    }
    return layer;
}

/// What a march gives when it is over: the phase functions stand outside of the sum.
///
/// Units:    the lights [L], sums of density times transmittance times step; column [L].
/// Domain:   all.
/// Accuracy: rounding.
/// Errors:   none.
/// Source:   all four documents.
template <typename T, typename Scene = DefaultScene>
Scattered<T> finished(const Atmosphere<T>& atmosphere, const vec3<T>& rayleigh_light,
                      const vec3<T>& mie_light, const Column<T>& column, T cos_theta) {
    vec3<T> radiance = atmosphere.rayleigh_scattering * rayleigh_light * rayleigh_phase(cos_theta);
    if constexpr (Scene::mie) {
        radiance += atmosphere.mie_scattering * mie_light * mie_phase<T, Scene>(cos_theta, atmosphere.mie_g);
    }
    return Scattered<T>{radiance, glm::exp(-column_optical_depth<T, Scene>(atmosphere, column))};
}

/// What a ray without air gives.
///
/// Units:    none.
/// Domain:   none, it takes no argument.
/// Accuracy: exact.
/// Errors:   none.
/// Source:   none.
template <typename T>
Scattered<T> nothing_scattered() {
    return Scattered<T>{vec3<T>(T(0), T(0), T(0)), vec3<T>(T(1), T(1), T(1))};
}

}  // namespace baseline

}  // namespace airlight
