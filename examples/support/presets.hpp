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
