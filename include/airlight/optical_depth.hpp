#pragma once

#include <airlight/column.hpp>

namespace airlight {

/// Optical depth of a given amount of air: each column times its extinction, summed.
///
///     tau = rayleigh_scattering C_R + (mie_scattering + mie_absorption) C_M + ozone_absorption C_O
///
/// Units:    column [L]; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   columns >= 0.
/// Accuracy: under 4 ulp.
/// Errors:   none.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
[[gnu::always_inline]] inline vec3<T> column_optical_depth(const Atmosphere<T>& atmosphere,
                                                           const Column<T>& column) {
    vec3<T> depth = atmosphere.rayleigh_scattering * column.rayleigh;
    if constexpr (Scene::mie) {
        depth += (atmosphere.mie_scattering + atmosphere.mie_absorption) * column.mie;
    }
    if constexpr (Scene::ozone != ozone_none) {
        depth += atmosphere.ozone_absorption * column.ozone;
    }
    return depth;
}

/// Optical depth along a ray, the integral of extinction over its length.
///
/// Units:    altitude and distance [L]; mu [1]; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   that of column.
/// Accuracy: that of column.
/// Errors:   none; ignores the ground as column does.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
vec3<T> optical_depth(const Atmosphere<T>& atmosphere, T altitude, T mu, T distance) {
    const Column<T> air = column<T, Scene>(atmosphere, altitude, mu, distance);
    return column_optical_depth<T, Scene>(atmosphere, air);
}

}  // namespace airlight
