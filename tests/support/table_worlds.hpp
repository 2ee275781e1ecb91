#pragma once

// Worlds whose tables differ: thin air around a large planet, thick air around a small one.

#include <airlight/atmospheres.hpp>
#include <vector>

#include "converted.hpp"
#include "worlds.hpp"

namespace airlight_test {

struct TableWorld {
    const char* name;
    airlight::Atmosphere<double> air;
};

inline std::vector<TableWorld> table_worlds() {
    using namespace airlight;
    Atmosphere<double> far = titan<double>();
    far.top_altitude = 1.2e6;  // half as much air as planet
    Atmosphere<double> toy = earth<double>();
    toy.ground_radius = 6e4;
    toy.top_altitude = 6e4;
    return {{"earth", earth<double>()},
            {"earth in km", rescaled(earth<double>(), 1e-3)},
            {"mars", mars<double>()},
            {"titan", far},
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
