#pragma once

// The library's atmospheres by the names that programs give them.

#include <airlight/atmospheres.hpp>
#include <airlight/scene.hpp>
#include <string>
#include <vector>

#include "error.hpp"

namespace support {

struct Preset {
    std::string name;
    airlight::Atmosphere<double> air;
    int ozone;  ///< profile of the absorbing layer, airlight::ozone_tent and so on
};

template <int Profile>
struct SceneWithOzone : airlight::DefaultScene {
    static constexpr int ozone = Profile;
};

/// Calls call(scene) with the scene that has this profile of the absorbing layer.
template <typename Call>
auto with_ozone(int ozone, const Call& call) {
    switch (ozone) {
        case airlight::ozone_tent:
            return call(SceneWithOzone<airlight::ozone_tent>{});
        case airlight::ozone_lorentzian:
            return call(SceneWithOzone<airlight::ozone_lorentzian>{});
        default:
            return call(SceneWithOzone<airlight::ozone_none>{});
    }
}

/// The preset's numbers in another scalar.
template <typename T>
airlight::Atmosphere<T> converted(const airlight::Atmosphere<double>& a) {
    using vec3 = airlight::vec3<T>;
    return {T(a.ground_radius),          T(a.top_altitude),
            vec3(a.rayleigh_scattering), T(a.rayleigh_scale_height),
            vec3(a.mie_scattering),      vec3(a.mie_absorption),
            T(a.mie_scale_height),       T(a.mie_g),
            vec3(a.ozone_absorption),    T(a.ozone_altitude),
            T(a.ozone_half_width),       vec3(a.ground_albedo)};
}

inline std::vector<Preset> presets() {
    return {{"earth", airlight::earth<double>(), airlight::ozone_tent},
            {"cs562", airlight::cs562_earth<double>(), airlight::ozone_none},
            {"elek", airlight::elek_earth<double>(), airlight::ozone_none},
            {"leenman", airlight::leenman_earth<double>(), airlight::ozone_lorentzian},
            {"mars", airlight::mars<double>(), airlight::ozone_none}};
}

/// Throws Error with the names that there are.
inline Preset preset(const std::string& name) {
    std::string names;
    for (const Preset& candidate : presets()) {
        if (candidate.name == name) {
            return candidate;
        }
        names += (names.empty() ? "" : ", ") + candidate.name;
    }
    throw Error("there is no atmosphere '" + name + "': take one of " + names);
}

}  // namespace support
