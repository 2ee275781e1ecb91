#pragma once

#include <baselines/march.hpp>

namespace airlight {

namespace baseline {

/// Schueler's approximation of Chapman's function times the density.
///
/// Units:    x = ground radius / scale height, height = altitude / scale height, mu and result [1].
/// Domain:   x > 0; height >= 0; mu in [-1, 1].
/// Accuracy: measured in docs/trade.md.
/// Errors:   none; the growth towards the planet's centre ends at e^40.
/// Source:   Schueler, An approximation to the Chapman grazing-incidence function for atmospheric
///           scattering, GPU Pro 3 (2012), as many shaders carry it. His unit is the height of half
///           density, ln 2 = 0.693147 scale heights; the limit is ours.
template <typename T>
T schueler_chapman(T x, T height, T mu) {
    const T half_heights = T(1.4426950408889634074L);
    const T c = glm::sqrt(half_heights * (x + height));
    const T above = c / (c * glm::abs(mu) + T(1)) * glm::exp(-height);
    if (mu >= T(0)) {
        return above;
    }
    const T perigee = safe_sqrt((T(1) - mu) * (T(1) + mu)) * (x + height);
    const T at_perigee = glm::sqrt(half_heights * perigee) * glm::exp(glm::min(x - perigee, T(40)));
    return T(2) * at_perigee - above;
}

/// One loop with Schueler's Chapman function in place of the march towards the sun.
///
/// Units:    those of single_scattering_marched.
/// Domain:   that of single_scattering_marched; steps >= 1.
/// Accuracy: measured in docs/trade.md.
/// Errors:   none; the planet's shadow is soft, made by the growth of the density below the ground.
/// Source:   schueler_chapman; the loop is the midpoint rule, the absorbing layer airlight's.
template <typename T, typename Scene = DefaultScene>
Scattered<T> schueler(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                      const vec3<T>& to_sun, T distance, int steps) {
    const March<T> march = march_of(atmosphere, eye, direction, distance);
    if (!march.in_air) {
        return nothing_scattered<T>();
    }
    const Layers<T> layers = layers_of<T, Scene>(atmosphere);
    const T ground = atmosphere.ground_radius;
    const T step = march.extent / T(steps);
    Sums<T> sums = Sums<T>{Column<T>{T(0), T(0), T(0)}, vec3<T>(T(0), T(0), T(0)), vec3<T>(T(0), T(0), T(0))};
    for (int i = 0; i < steps; ++i) {
        const vec3<T> here = march.start + (T(i) + T(0.5)) * step * direction;
        const T altitude = glm::max(altitude_of(atmosphere, here), T(0));
        const T mu_s = glm::clamp(dot_product(here, to_sun) / (ground + altitude), T(-1), T(1));
        const T h_r = atmosphere.rayleigh_scale_height;
        const T rayleigh = h_r * schueler_chapman(ground / h_r, altitude / h_r, mu_s);
        T mie = T(0);
        if constexpr (Scene::mie) {
            const T h_m = atmosphere.mie_scale_height;
            mie = h_m * schueler_chapman(ground / h_m, altitude / h_m, mu_s);
        }
        const Column<T> towards_sun =
            Column<T>{rayleigh, mie, layer_to_sun<T, Scene>(atmosphere, layers, ground + altitude, mu_s)};
        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        sums = after_step<T, Scene>(atmosphere, sums, density, towards_sun, step);
    }
    return finished<T, Scene>(atmosphere, sums.rayleigh_light, sums.mie_light, sums.passed,
                              dot_product(direction, to_sun));
}

}  // namespace baseline

}  // namespace airlight
