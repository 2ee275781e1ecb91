#pragma once

#include <baselines/march.hpp>

namespace airlight {

namespace baseline {

/// Densities that go on growing below the ground: the planet's shadow of a method that never asks
/// whether the planet is in the way.
///
/// Units:    altitude [L]; result [1].
/// Domain:   every altitude.
/// Accuracy: that of the density functions.
/// Errors:   none; the growth ends at e^40, so that a coefficient of 0 never meets an infinity.
/// Source:   Leenman, Atmospheric scattering explained (2021); the limit is ours.
template <typename T, typename Scene = DefaultScene>
Density<T> growing_density(const Atmosphere<T>& atmosphere, T altitude) {
    const T rayleigh = glm::exp(glm::min(-altitude / atmosphere.rayleigh_scale_height, T(40)));
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = glm::exp(glm::min(-altitude / atmosphere.mie_scale_height, T(40)));
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

/// Leenman's shader: a march along the view ray, and at each sample a march towards the sun.
///
/// The whole of a step's air dims its own light. Left out is the shader's choice to hide the
/// aerosol's light in front of surfaces.
///
/// Units:    those of single_scattering_marched.
/// Domain:   that of single_scattering_marched; view_steps and sun_steps >= 1. The shader's own
///           numbers are 16 and 6, on weak machines 12 and 4.
/// Accuracy: measured in docs/trade.md.
/// Errors:   a sun just below the horizon shines through the planet between two samples.
/// Source:   Leenman, Atmospheric scattering explained (2021).
template <typename T, typename Scene = DefaultScene>
Scattered<T> leenman(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                     const vec3<T>& to_sun, T distance, int view_steps, int sun_steps) {
    const March<T> march = march_of(atmosphere, eye, direction, distance);
    if (!march.in_air) {
        return nothing_scattered<T>();
    }
    const T top_radius = atmosphere.ground_radius + atmosphere.top_altitude;
    const T view_step = march.extent / T(view_steps);
    Column<T> passed = Column<T>{T(0), T(0), T(0)};
    vec3<T> rayleigh_light = vec3<T>(T(0), T(0), T(0));
    vec3<T> mie_light = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < view_steps; ++i) {
        const vec3<T> here = march.start + (T(i) + T(0.5)) * view_step * direction;
        const Density<T> density = growing_density<T, Scene>(atmosphere, altitude_of(atmosphere, here));
        passed = extended(passed, density, view_step);

        const T sun_step = distance_out(here, to_sun, top_radius) / T(sun_steps);
        Column<T> towards_sun = Column<T>{T(0), T(0), T(0)};
        for (int j = 0; j < sun_steps; ++j) {
            const vec3<T> there = here + (T(j) + T(0.5)) * sun_step * to_sun;
            const T altitude = altitude_of(atmosphere, there);
            towards_sun = extended(towards_sun, growing_density<T, Scene>(atmosphere, altitude), sun_step);
        }

        const vec3<T> share =
            glm::exp(-column_optical_depth<T, Scene>(atmosphere, joined(passed, towards_sun)));
        rayleigh_light += density.rayleigh * view_step * share;
        mie_light += density.mie * view_step * share;
    }
    return finished<T, Scene>(atmosphere, rayleigh_light, mie_light, passed, dot_product(direction, to_sun));
}

}  // namespace baseline

}  // namespace airlight
