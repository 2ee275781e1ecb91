#include "worlds.hpp"

namespace study {
namespace {

/// The default Earth without ozone and with ten times its molecules.
airlight::Atmosphere<double> thick() {
    airlight::Atmosphere<double> air = airlight::earth<double>();
    air.rayleigh_scattering *= 10.0;
    air.ozone_absorption *= 0.0;
    return air;
}

}  // namespace

const std::vector<World>& worlds() {
    static const std::vector<World> all = {
        {"leenman", "Leenman's Earth, Lorentzian ozone", airlight::leenman_earth<double>(),
         airlight::ozone_lorentzian},
        {"cs562", "hazy Earth of CS562, no ozone", airlight::cs562_earth<double>(), airlight::ozone_none},
        {"earth", "Earth, ozone as a tent", airlight::earth<double>(), airlight::ozone_tent},
        {"mars", "Mars with its dust", airlight::mars<double>(), airlight::ozone_none},
        {"thick", "Earth with ten times the molecules", thick(), airlight::ozone_none},
    };
    return all;
}

}  // namespace study
