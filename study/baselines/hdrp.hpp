#pragma once

#include <baselines/march.hpp>

namespace airlight {

namespace baseline {

/// Chapman's function upwards as Unity's HDRP approximates it.
///
/// Units:    z = radius / scale height, mu and result [1].
/// Domain:   z > 0; mu in [0, 1].
/// Accuracy: measured in docs/trade.md.
/// Errors:   none.
/// Source:   the sky of Unity's High Definition Render Pipeline, PhysicallyBasedSkyCommon.hlsl.
template <typename T>
T hdrp_chapman(T z, T mu) {
    const T slant = mu * mu * z;
    const T above = T(0.761643L) * (T(1) + T(2) * z - slant);
    const T below = mu * z + glm::sqrt(z * (T(1.47721L) + T(0.273828L) * slant));
    return T(0.5) * mu + above / below;
}

/// The exponential air between a point and space as HDRP has it, over the density at the ground.
///
/// Units:    ground_radius, altitude, scale_height and result [L]; mu [1].
/// Domain:   altitude >= 0; mu in [-1, 1], above the horizon.
/// Accuracy: that of hdrp_chapman; downwards twice that at the closest approach.
/// Errors:   none.
/// Source:   the sky of Unity's High Definition Render Pipeline, PhysicallyBasedSkyCommon.hlsl.
template <typename T>
T hdrp_column(T ground_radius, T altitude, T scale_height, T mu) {
    const T z = (ground_radius + altitude) / scale_height;
    const T above = hdrp_chapman(z, glm::abs(mu)) * glm::exp(-altitude / scale_height);
    if (mu >= T(0)) {
        return scale_height * above;
    }
    const T perigee = z * safe_sqrt((T(1) - mu) * (T(1) + mu));
    const T root = glm::sqrt(perigee);
    const T at_perigee =
        T(0.626657L) * (T(1) / root + T(2) * root) * glm::exp(ground_radius / scale_height - perigee);
    return scale_height * (T(2) * at_perigee - above);
}

/// One loop with HDRP's Chapman function in place of the march towards the sun.
///
/// HDRP fills a table of four dimensions with such sums and reads that; here the sum itself is taken, so
/// the error is the formula's and the loop's alone.
///
/// Units:    those of single_scattering_marched.
/// Domain:   that of single_scattering_marched; steps >= 1.
/// Accuracy: measured in docs/trade.md.
/// Errors:   none.
/// Source:   hdrp_column; the loop is the midpoint rule, the absorbing layer airlight's.
template <typename T, typename Scene = DefaultScene>
Scattered<T> hdrp(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
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
        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        if (behind_planet(ground, altitude, mu_s)) {
            sums.passed = extended(sums.passed, density, step);
        } else {
            const T rayleigh = hdrp_column(ground, altitude, atmosphere.rayleigh_scale_height, mu_s);
            T mie = T(0);
            if constexpr (Scene::mie) {
                mie = hdrp_column(ground, altitude, atmosphere.mie_scale_height, mu_s);
            }
            const Column<T> towards_sun =
                Column<T>{rayleigh, mie, layer_to_sun<T, Scene>(atmosphere, layers, ground + altitude, mu_s)};
            sums = after_step<T, Scene>(atmosphere, sums, density, towards_sun, step);
        }
    }
    return finished<T, Scene>(atmosphere, sums.rayleigh_light, sums.mie_light, sums.passed,
                              dot_product(direction, to_sun));
}

}  // namespace baseline

}  // namespace airlight
