#pragma once

// Worlds whose tables differ: thin air around a large planet, thick air around a small one.

#include <airlight/atmospheres.hpp>
#include <vector>

#include "converted.hpp"

namespace airlight_test {

/// Thick, hazy and small, as Titan is.
inline airlight::Atmosphere<double> hazy_titan() {
    airlight::Atmosphere<double> air = airlight::earth<double>();
    air.ground_radius = 2575e3;
    air.top_altitude = 400e3;
    air.rayleigh_scale_height = air.mie_scale_height = 40e3;
    air.mie_scattering = airlight::vec3<double>(1e-5, 2e-5, 4e-5);
    return air;
}

struct TableWorld {
    const char* name;
    airlight::Atmosphere<double> air;
};

inline std::vector<TableWorld> table_worlds() {
    using namespace airlight;
    Atmosphere<double> titan = earth<double>();  // half as much air as planet, as on Titan
    titan.ground_radius = 2.575e6;
    titan.top_altitude = 1.2e6;
    titan.rayleigh_scale_height = 2.1e4;
    Atmosphere<double> toy = earth<double>();
    toy.ground_radius = 6e4;
    toy.top_altitude = 6e4;
    return {{"earth", earth<double>()},
            {"earth in km", rescaled(earth<double>(), 1e-3)},
            {"mars", mars<double>()},
            {"titan", titan},
            {"60 km world", toy}};
}

/// The same, a pebble in a cloud that floats cannot aim at, and a rock without air.
inline std::vector<TableWorld> all_table_worlds() {
    using namespace airlight;
    std::vector<TableWorld> worlds = table_worlds();
    Atmosphere<double> pebble = earth<double>();
    pebble.ground_radius = 1e3;
    pebble.top_altitude = 1e5;
    Atmosphere<double> bare = earth<double>();
    bare.top_altitude = 0.0;
    worlds.push_back({"pebble", pebble});
    worlds.push_back({"no air", bare});
    return worlds;
}

}  // namespace airlight_test
