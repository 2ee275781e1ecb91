#pragma once

// The atmospheres of the study.

#include <airlight/airlight.hpp>
#include <string>
#include <vector>

namespace study {

struct World {
    std::string name;
    std::string title;  ///< in a sentence
    airlight::Atmosphere<double> air;
    int ozone;  ///< profile of the absorbing layer, airlight::ozone_none and so on
};

/// All five: Leenman's, the CS562 renderer's, the default Earth, Mars, and a thick one.
const std::vector<World>& worlds();

/// The same atmosphere in another scalar type.
template <typename T>
airlight::Atmosphere<T> converted(const airlight::Atmosphere<double>& a) {
    const auto spectrum = [](const airlight::vec3<double>& v) {
        return airlight::vec3<T>(T(v.x), T(v.y), T(v.z));
    };
    return airlight::Atmosphere<T>{T(a.ground_radius),
                                   T(a.top_altitude),
                                   spectrum(a.rayleigh_scattering),
                                   T(a.rayleigh_scale_height),
                                   spectrum(a.mie_scattering),
                                   spectrum(a.mie_absorption),
                                   T(a.mie_scale_height),
                                   T(a.mie_g),
                                   spectrum(a.ozone_absorption),
                                   T(a.ozone_altitude),
                                   T(a.ozone_half_width),
                                   spectrum(a.ground_albedo)};
}

}  // namespace study
