#pragma once

#include <airlight/constants.hpp>
#include <airlight/optical_depth.hpp>

namespace airlight {

/// Share of light that passes along a ray, exp(-optical_depth).
///
/// Units:    altitude and distance [L]; mu [1]; result [1], in [0, 1].
/// Shape:    the result is a spectrum.
/// Domain:   that of optical_depth.
/// Accuracy: relative error equal to the absolute error of optical_depth, plus exp's own.
/// Errors:   none; ignores the ground.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
vec3<T> transmittance(const Atmosphere<T>& atmosphere, T altitude, T mu, T distance) {
    return glm::exp(-optical_depth<T, Scene>(atmosphere, altitude, mu, distance));
}

/// Mean of exp(-x) over a step of optical depth x: (1 - exp(-x)) / x.
///
/// Units:    depth [1] and passed = exp(-depth); result [1].
/// Shape:    depth, passed and the result are spectra.
/// Domain:   depth >= 0, infinity included.
/// Accuracy: 2e-6, plus 64 roundoffs.
/// Errors:   none; 1 where the depth is 0.
/// Source:   Taylor's series where the difference cancels.
template <typename T>
vec3<T> mean_passed(const vec3<T>& depth, const vec3<T>& passed) {
    const T thin = T(0.03L);
    const T third = T(0.333333333333333333333333333333333333L);
    const vec3<T> series = T(1) - T(0.5) * depth * (T(1) - third * depth);
    return vec3<T>(depth.x < thin ? series.x : (T(1) - passed.x) / depth.x,
                   depth.y < thin ? series.y : (T(1) - passed.y) / depth.y,
                   depth.z < thin ? series.z : (T(1) - passed.z) / depth.z);
}

/// Whether the ground sphere hides a far source from a point.
///
/// Units:    ground_radius and altitude [L]; mu [1], cosine between the source and the vertical.
/// Domain:   ground_radius > 0; altitude below the ground counts as 0; mu in [-1, 1].
/// Accuracy: exact for inputs moved by at most 3 unit roundoffs.
/// Errors:   a source exactly on the horizon is not hidden; NaN is not hidden.
/// Source:   the gap of intersect_ray_sphere.
template <typename T>
bool behind_planet(T ground_radius, T altitude, T mu) {
    const T above = glm::max(altitude, T(0));
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    return mu < T(0) && ground_radius * (mu * mu / (T(1) + sine)) > above * sine;
}

/// Share of light that reaches a point from a far source, 0 where the planet hides it.
///
/// Units:    altitude [L]; mu [1], cosine between the source and the vertical; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   that of optical_depth.
/// Accuracy: that of transmittance.
/// Errors:   none; without Scene::planet_shadow the ground is ignored.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
vec3<T> transmittance_to_space(const Atmosphere<T>& atmosphere, T altitude, T mu) {
    if constexpr (Scene::planet_shadow) {
        if (behind_planet(atmosphere.ground_radius, altitude, mu)) {
            return vec3<T>(T(0), T(0), T(0));
        }
    }
    return transmittance<T, Scene>(atmosphere, altitude, mu, no_surface<T>());
}

/// Hook: the share of light that reaches a point from a far source, 0 where the planet hides it. By default
/// it is computed; a table takes its place. A macro sees the caller's `atmosphere`.
template <typename Scene = DefaultScene>
struct ComputedTransmittance {
    template <typename T>
    vec3<T> operator()(const Atmosphere<T>& atmosphere, T altitude, T mu) const {
        return transmittance_to_space<T, Scene>(atmosphere, altitude, mu);
    }
};

}  // namespace airlight
