#pragma once

#include <baselines/march.hpp>

namespace airlight {

namespace baseline {

/// The direction that the table of the CS562 renderer keeps at a texture coordinate, as the cosine to
/// the vertical: that of (1 - |a|, a), which is neither an angle nor a cosine.
///
/// Units:    u and result [1].
/// Domain:   u in [0, 1].
/// Accuracy: rounding.
/// Errors:   none.
/// Source:   Deferred atmospheric scattering, a CS562 project report; its small offset of the angle
///           has no number and is left out.
template <typename T>
T cs562_cosine(T u) {
    const T a = T(2) * u - T(1);
    const T across = T(1) - glm::abs(a);
    return a / glm::sqrt(across * across + a * a);
}

/// Where the table of the CS562 renderer keeps an altitude and a cosine to the vertical.
///
/// Units:    altitude [L]; mu and result [1].
/// Domain:   altitude in [0, top_altitude]; mu in [-1, 1].
/// Accuracy: rounding.
/// Errors:   none.
/// Source:   the inverse of cs562_cosine; the report does not show its look-up.
template <typename T>
vec2<T> cs562_uv(const Atmosphere<T>& atmosphere, T altitude, T mu) {
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    return vec2<T>(T(0.5) + T(0.5) * mu / (glm::abs(mu) + sine), altitude / atmosphere.top_altitude);
}

/// One texel of the table of the CS562 renderer: the share of sunlight that arrives.
///
/// Sums one sample more than there are intervals and weights all alike, as the report does.
///
/// Units:    uv and result [1].
/// Domain:   uv in [0, 1] x [0, 1]; intervals >= 1.
/// Accuracy: first order in the interval.
/// Errors:   none; 0 where the planet is in the way.
/// Source:   Deferred atmospheric scattering, a CS562 project report, which gives no number of samples.
template <typename T, typename Scene = DefaultScene>
vec3<T> cs562_texel(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int intervals) {
    const T altitude = uv.y * atmosphere.top_altitude;
    const T mu = cs562_cosine(uv.x);
    if (behind_planet(atmosphere.ground_radius, altitude, mu)) {
        return vec3<T>(T(0), T(0), T(0));
    }
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    const vec3<T> start = vec3<T>(T(0), T(0), atmosphere.ground_radius + altitude);
    const vec3<T> direction = vec3<T>(sine, T(0), mu);
    const T step =
        distance_out(start, direction, atmosphere.ground_radius + atmosphere.top_altitude) / T(intervals);
    Column<T> column = Column<T>{T(0), T(0), T(0)};
    for (int i = 0; i < intervals; ++i) {
        const T here = altitude_of(atmosphere, start + T(i) * step * direction);
        column = extended(column, relative_density<T, Scene>(atmosphere, here), step);
    }
    const Density<T> last = relative_density<T, Scene>(atmosphere, atmosphere.top_altitude);
    return glm::exp(-column_optical_depth<T, Scene>(atmosphere, extended(column, last, step)));
}

/// The march of the CS562 renderer, with its table of the sun's transmittance, 256 by 256 texels.
///
/// Sums one sample more than there are intervals and weights all alike, the first at the eye.
///
/// Units:    those of single_scattering_marched.
/// Domain:   that of single_scattering_marched; samples >= 2, one more than the report's number of
///           steps, which is 20 to 30 for speed and 800 for shafts.
/// Accuracy: measured in docs/trade.md.
/// Errors:   the table blurs the planet's shadow.
/// Source:   Deferred atmospheric scattering, a CS562 project report.
template <typename T, typename Scene = DefaultScene, typename TransmittanceTable = NoTable>
Scattered<T> cs562(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                   const vec3<T>& to_sun, T distance, int samples,
                   const TransmittanceTable& transmittance_table = TransmittanceTable{}) {
    const March<T> march = march_of(atmosphere, eye, direction, distance);
    if (!march.in_air) {
        return nothing_scattered<T>();
    }
    const T step = march.extent / (T(samples) - T(1));
    Column<T> passed = Column<T>{T(0), T(0), T(0)};
    vec3<T> rayleigh_light = vec3<T>(T(0), T(0), T(0));
    vec3<T> mie_light = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < samples; ++i) {
        const vec3<T> here = march.start + T(i) * step * direction;
        const T radius = glm::sqrt(dot_product(here, here));
        const T altitude = radius - atmosphere.ground_radius;
        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        passed = extended(passed, density, step);
        const T mu_s = glm::clamp(dot_product(here, to_sun) / radius, T(-1), T(1));
        const vec3<T> share = transmittance_table(cs562_uv(atmosphere, altitude, mu_s)) *
                              glm::exp(-column_optical_depth<T, Scene>(atmosphere, passed));
        rayleigh_light += density.rayleigh * step * share;
        mie_light += density.mie * step * share;
    }
    return finished<T, Scene>(atmosphere, rayleigh_light, mie_light, passed, dot_product(direction, to_sun));
}

}  // namespace baseline

}  // namespace airlight
