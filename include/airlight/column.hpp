#pragma once

#include <airlight/atmosphere.hpp>
#include <airlight/density.hpp>
#include <airlight/ray_sphere.hpp>
#include <airlight/scene.hpp>
#include <airlight/view_path.hpp>

namespace airlight {

/// The amount of each substance along a ray: relative density integrated over length.
template <typename T>
struct Column {
    T rayleigh;  ///< [L] of molecules
    T mie;       ///< [L] of aerosol, 0 where the scene has none
    T ozone;     ///< [L] of the absorbing layer, 0 where the scene has none
};

/// The relative density [1] of each substance at one altitude.
template <typename T>
struct Density {
    T rayleigh;  ///< [1] of molecules
    T mie;       ///< [1] of aerosol, 0 where the scene has none
    T ozone;     ///< [1] of the absorbing layer, 0 where the scene has none
};

/// Relative densities at an altitude, for the terms that the scene has.
///
/// The Lorentzian layer is the Lorentz curve times the Rayleigh density: with Leenman's numbers it
/// peaks at 28.9 km, not 30, and at 0.025.
///
/// Units:    altitude [L]; result [1].
/// Domain:   every altitude; below the ground it counts as 0. The top of the air is the caller's.
/// Accuracy: that of the density functions.
/// Errors:   none; a layer of zero thickness gives 0.
/// Source:   exponential_density, tent_density, lorentzian_density.
template <typename T, typename Scene = DefaultScene>
Density<T> relative_density(const Atmosphere<T>& atmosphere, T altitude) {
    const T rayleigh = exponential_density(altitude, atmosphere.rayleigh_scale_height);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = exponential_density(altitude, atmosphere.mie_scale_height);
    }
    T ozone = T(0);
    if constexpr (Scene::ozone == ozone_tent) {
        ozone = tent_density(altitude, atmosphere.ozone_altitude, atmosphere.ozone_half_width);
    }
    if constexpr (Scene::ozone == ozone_lorentzian) {
        ozone =
            rayleigh * lorentzian_density(altitude, atmosphere.ozone_altitude, atmosphere.ozone_half_width);
    }
    return Density<T>{rayleigh, mie, ozone};
}

/// The air along a ray, summed over `steps` equal steps by the midpoint rule.
///
/// Ignores the ground: below it the densities keep their ground value.
///
/// Units:    altitude and distance [L]; mu [1], cosine to the vertical; result [L].
/// Domain:   altitude from the centre to a few planet radii (further out mu has no digits left);
///           below the ground it counts as 0; mu in [-1, 1]; distance >= 0; steps >= 1.
/// Accuracy: second order: four times better per doubling of steps, once a step is shorter than
///           the smallest scale height it crosses. Rounding: that of altitude_along_ray.
/// Errors:   steps < 1 gives 0.
/// Source:   midpoint rule.
template <typename T, typename Scene = DefaultScene>
Column<T> column_marched(const Atmosphere<T>& atmosphere, T altitude, T mu, T distance, int steps) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    const T from_altitude = glm::max(altitude, T(0));
    const T cosine = glm::clamp(mu, T(-1), T(1));
    const RaySphereHit<T> air = intersect_ray_sphere(radius + top, from_altitude - top, cosine);
    const T begin = glm::max(air.t_near, T(0));
    const T length = glm::max(glm::min(air.t_far, distance) - begin, T(0));

    // From the entry into the air if the ray starts above it: distances from there are short.
    const T start = begin > T(0) ? top : from_altitude;
    const T along = (radius + from_altitude) * cosine + begin;
    const T step_length = length / glm::max(T(steps), T(1));
    Column<T> sum = Column<T>{T(0), T(0), T(0)};
    for (int i = 0; i < steps; ++i) {
        const T here = altitude_along_ray(radius, start, along, (T(i) + T(0.5)) * step_length);
        const Density<T> density = relative_density<T, Scene>(atmosphere, here);
        sum.rayleigh += density.rayleigh;
        sum.mie += density.mie;
        sum.ozone += density.ozone;
    }
    return Column<T>{sum.rayleigh * step_length, sum.mie * step_length, sum.ozone * step_length};
}

}  // namespace airlight
