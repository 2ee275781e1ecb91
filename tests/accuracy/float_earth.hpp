#pragma once

// The Earth that float has, in wider types: the same numbers, not the constants rounded anew.

#include <airlight/atmospheres.hpp>

namespace float_error {

template <typename T>
airlight::Atmosphere<T> widened(const airlight::Atmosphere<float>& air) {
    using airlight::vec3;
    return airlight::Atmosphere<T>{air.ground_radius,
                                   air.top_altitude,
                                   vec3<T>(air.rayleigh_scattering),
                                   air.rayleigh_scale_height,
                                   vec3<T>(air.mie_scattering),
                                   vec3<T>(air.mie_absorption),
                                   air.mie_scale_height,
                                   air.mie_g,
                                   vec3<T>(air.ozone_absorption),
                                   air.ozone_altitude,
                                   air.ozone_half_width,
                                   vec3<T>(air.ground_albedo)};
}

}  // namespace float_error
