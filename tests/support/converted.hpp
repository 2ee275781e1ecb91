#pragma once

// What a function is given, in another scalar type: the same numbers, not the constants rounded anew.

#include <airlight/atmosphere.hpp>

namespace airlight_test {

template <typename T, typename U>
airlight::vec3<T> converted(const airlight::vec3<U>& v) {
    return airlight::vec3<T>(T(v.x), T(v.y), T(v.z));
}

template <typename T, typename U>
airlight::Atmosphere<T> converted(const airlight::Atmosphere<U>& air) {
    return airlight::Atmosphere<T>{T(air.ground_radius),
                                   T(air.top_altitude),
                                   converted<T>(air.rayleigh_scattering),
                                   T(air.rayleigh_scale_height),
                                   converted<T>(air.mie_scattering),
                                   converted<T>(air.mie_absorption),
                                   T(air.mie_scale_height),
                                   T(air.mie_g),
                                   converted<T>(air.ozone_absorption),
                                   T(air.ozone_altitude),
                                   T(air.ozone_half_width),
                                   converted<T>(air.ground_albedo)};
}

}  // namespace airlight_test
