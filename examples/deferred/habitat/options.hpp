#pragma once

#include <optional>
#include <string>
#include <vector>

#include "habitat/world.hpp"
#include "settings.hpp"

namespace deferred::habitat {

/// What the command line asks for.
struct Options {
    std::vector<Camera> cameras;
    World world;
    bool plain;  ///< land of one colour, without relief
    Settings settings;
    int width;
    int height;
    std::string height_map;
    double step_east;   ///< [m]
    double step_north;  ///< [m]
    std::string output;
    std::string shaders;  ///< folder of the example's own; empty for the one of the sources
    std::optional<float> exposure;
    bool times;
    bool difference;
    std::optional<double> tolerance;  ///< of the largest relative difference
    int truth;                        ///< walks a pixel and colour of the path-traced picture; 0 for none
};

/// The options, or nothing when --help was asked for and is printed. Throws support::Error.
std::optional<Options> parse_options(int count, char** arguments);

}  // namespace deferred::habitat
