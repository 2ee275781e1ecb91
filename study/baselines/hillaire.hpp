#pragma once

#include <baselines/march.hpp>

namespace airlight {

namespace baseline {

/// Where Bruneton's and Hillaire's table keeps an altitude and a cosine to the vertical: the way to the
/// air's top between its shortest and its longest, and the way to the horizon.
///
/// Units:    altitude [L]; mu and result [1].
/// Domain:   altitude in [0, top_altitude]; mu in [-1, 1].
/// Accuracy: rounding; near the ground a roundoff of the squared radius.
/// Errors:   none; at the very top the first coordinate is 0.
/// Source:   Bruneton, Precomputed Atmospheric Scattering (2017), functions.glsl; Hillaire's demo of A
///           Scalable and Production Ready Sky (2020), SkyAtmosphereCommon.hlsl.
template <typename T>
vec2<T> hillaire_uv(const Atmosphere<T>& atmosphere, T altitude, T mu) {
    const T ground = atmosphere.ground_radius;
    const T top = ground + atmosphere.top_altitude;
    const T radius = ground + altitude;
    const T longest = glm::sqrt(top * top - ground * ground);
    const T to_horizon = safe_sqrt(radius * radius - ground * ground);
    const T to_top = glm::max(safe_sqrt(radius * radius * (mu * mu - T(1)) + top * top) - radius * mu, T(0));
    const T shortest = top - radius;
    return vec2<T>((to_top - shortest) / (to_horizon + longest - shortest), to_horizon / longest);
}

/// One texel of Hillaire's table of the sun's transmittance.
///
/// Samples stand at 0.3 of each step and count the way from the last sample.
///
/// Units:    uv and result [1].
/// Domain:   uv in [0, 1] x [0, 1]; steps >= 1, his are 40.
/// Accuracy: first order in the step.
/// Errors:   none.
/// Source:   Hillaire's demo of A Scalable and Production Ready Sky (2020), RenderSkyRayMarching.hlsl.
template <typename T, typename Scene = DefaultScene>
vec3<T> hillaire_texel(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int steps) {
    const T ground = atmosphere.ground_radius;
    const T top = ground + atmosphere.top_altitude;
    const T longest = glm::sqrt(top * top - ground * ground);
    const T to_horizon = uv.y * longest;
    const T radius = glm::sqrt(to_horizon * to_horizon + ground * ground);
    const T shortest = top - radius;
    const T to_top = shortest + uv.x * (to_horizon + longest - shortest);
    const T above = longest * longest - to_horizon * to_horizon - to_top * to_top;
    const T mu = to_top > T(0) ? glm::clamp(above / (T(2) * radius * to_top), T(-1), T(1)) : T(1);
    const vec3<T> start = vec3<T>(T(0), T(0), radius);
    const vec3<T> direction = vec3<T>(safe_sqrt((T(1) - mu) * (T(1) + mu)), T(0), mu);
    Column<T> column = Column<T>{T(0), T(0), T(0)};
    T last = T(0);
    for (int i = 0; i < steps; ++i) {
        const T way = to_top * (T(i) + T(0.3L)) / T(steps);
        const T here = altitude_of(atmosphere, start + way * direction);
        column = extended(column, relative_density<T, Scene>(atmosphere, here), way - last);
        last = way;
    }
    return glm::exp(-column_optical_depth<T, Scene>(atmosphere, column));
}

/// Hillaire's march, with his table of the sun's transmittance, 256 by 64 texels.
///
/// Each step's light is dimmed within the step in closed form, as if density and sunlight were even
/// there. Steps are equal; samples stand at 0.3 of each and count the way from the last sample. His
/// aerosol scatters by Henyey and Greenstein: here it is the scene's choice.
///
/// Units:    those of single_scattering_marched.
/// Domain:   that of single_scattering_marched; steps >= 1, in his paper 30; some extinction in each
///           channel.
/// Accuracy: measured in docs/trade.md.
/// Errors:   air without any extinction divides zero by zero.
/// Source:   Hillaire's demo of A Scalable and Production Ready Sky (2020), RenderSkyRayMarching.hlsl:
///           the march with a fixed number of steps.
template <typename T, typename Scene = DefaultScene, typename TransmittanceTable = NoTable>
Scattered<T> hillaire(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                      const vec3<T>& to_sun, T distance, int steps,
                      const TransmittanceTable& transmittance_table = TransmittanceTable{}) {
    const March<T> march = march_of(atmosphere, eye, direction, distance);
    if (!march.in_air) {
        return nothing_scattered<T>();
    }
    const T cos_theta = dot_product(direction, to_sun);
    const vec3<T> rayleigh_source = atmosphere.rayleigh_scattering * rayleigh_phase(cos_theta);
    vec3<T> mie_source = vec3<T>(T(0), T(0), T(0));
    if constexpr (Scene::mie) {
        mie_source = atmosphere.mie_scattering * mie_phase<T, Scene>(cos_theta, atmosphere.mie_g);
    }
    vec3<T> radiance = vec3<T>(T(0), T(0), T(0));
    vec3<T> seen = vec3<T>(T(1), T(1), T(1));
    T last = T(0);
    for (int i = 0; i < steps; ++i) {
        const T way = march.extent * (T(i) + T(0.3L)) / T(steps);
        const vec3<T> here = march.start + way * direction;
        const T radius = glm::sqrt(dot_product(here, here));
        const T altitude = glm::max(radius - atmosphere.ground_radius, T(0));
        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        const vec3<T> extinction = column_optical_depth<T, Scene>(
            atmosphere, Column<T>{density.rayleigh, density.mie, density.ozone});
        const vec3<T> share = glm::exp(-extinction * (way - last));

        // His shadow test moves the planet's centre 10 m of 6360 km towards the sample. A sample lower
        // than that, which he leaves dark, counts as standing on the ground here.
        const T mu_s = glm::clamp(dot_product(here, to_sun) / radius, T(-1), T(1));
        const T lift = atmosphere.ground_radius * T(1.5723270440251572327e-6L);
        const bool hidden = behind_planet(atmosphere.ground_radius, altitude - lift, mu_s);
        vec3<T> sunlit = vec3<T>(T(0), T(0), T(0));
        if (!hidden) {
            sunlit = transmittance_table(hillaire_uv(atmosphere, altitude, mu_s));
        }
        const vec3<T> source = sunlit * (density.rayleigh * rayleigh_source + density.mie * mie_source);
        radiance += seen * (source - source * share) / extinction;
        seen *= share;
        last = way;
    }
    return Scattered<T>{radiance, seen};
}

}  // namespace baseline

}  // namespace airlight
