#pragma once

#include <baselines/march.hpp>

namespace airlight {

namespace baseline {

/// The air on a stretch, summed in the middles of equal steps.
///
/// Units:    lengths [L]; direction a unit vector.
/// Domain:   steps >= 1.
/// Accuracy: second order in the step.
/// Errors:   none; below the ground the densities keep their ground value.
/// Source:   Notes on precomputed atmospheric scattering in Unity.
template <typename T, typename Scene = DefaultScene>
Column<T> summed_column(const Atmosphere<T>& atmosphere, const vec3<T>& start, const vec3<T>& direction,
                        T extent, int steps) {
    const T step = extent / T(steps);
    Column<T> column = Column<T>{T(0), T(0), T(0)};
    for (int i = 0; i < steps; ++i) {
        const T altitude = altitude_of(atmosphere, start + (T(i) + T(0.5)) * step * direction);
        column = extended(column, relative_density<T, Scene>(atmosphere, altitude), step);
    }
    return column;
}

/// The double loop of the notes on precomputed scattering: at each sample two further loops, back to
/// the eye and on towards the sun.
///
/// Read at the sample: the notes take the absolute value of a height below the ground there and 0 in
/// their loops; here both are 0. Their listing ends before the sum, which is taken as written in their
/// text: the samples' light times the step.
///
/// Units:    those of single_scattering_marched.
/// Domain:   that of single_scattering_marched; steps >= 1, in the notes 64 for each loop.
/// Accuracy: measured in docs/trade.md.
/// Errors:   none.
/// Source:   Notes on precomputed atmospheric scattering in Unity.
template <typename T, typename Scene = DefaultScene>
Scattered<T> double_loop(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                         const vec3<T>& to_sun, T distance, int steps) {
    const March<T> march = march_of(atmosphere, eye, direction, distance);
    if (!march.in_air) {
        return nothing_scattered<T>();
    }
    const T radius = atmosphere.ground_radius;
    const T step = march.extent / T(steps);
    vec3<T> rayleigh_light = vec3<T>(T(0), T(0), T(0));
    vec3<T> mie_light = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < steps; ++i) {
        const T way = (T(i) + T(0.5)) * step;
        const vec3<T> here = march.start + way * direction;
        const T towards = dot_product(here, to_sun);
        const T outside = dot_product(here, here) - radius * radius;
        const bool hidden = towards < T(0) && towards * towards > outside;
        if (!hidden) {
            const Density<T> density = relative_density<T, Scene>(atmosphere, altitude_of(atmosphere, here));
            const T sun_way = distance_out(here, to_sun, radius + atmosphere.top_altitude);
            const Column<T> to_eye = summed_column<T, Scene>(atmosphere, march.start, direction, way, steps);
            const Column<T> on_to_sun = summed_column<T, Scene>(atmosphere, here, to_sun, sun_way, steps);
            const vec3<T> share =
                glm::exp(-column_optical_depth<T, Scene>(atmosphere, joined(to_eye, on_to_sun)));
            rayleigh_light += density.rayleigh * step * share;
            mie_light += density.mie * step * share;
        }
    }
    const Column<T> whole = summed_column<T, Scene>(atmosphere, march.start, direction, march.extent, steps);
    return finished<T, Scene>(atmosphere, rayleigh_light, mie_light, whole, dot_product(direction, to_sun));
}

}  // namespace baseline

}  // namespace airlight
