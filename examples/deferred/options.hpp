#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "path.hpp"
#include "settings.hpp"
#include "tables.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

inline constexpr int largest_coarseness = 8;

/// What the command line asks for.
struct Options {
    bool window = false;               ///< else pictures
    std::optional<int> window_frames;  ///< then it closes
    int coarseness;                    ///< pixels of the window each way that share one of the picture
    std::string screenshot;            ///< of its last frame; "" for none
    std::vector<std::pair<int, int>> window_sizes;  ///< that it takes, one a frame
    bool times = false;                             ///< print GPU times
    std::vector<Camera> cameras;
    std::vector<double> sun_elevations;  ///< [degrees]
    double sun_azimuth;                  ///< [degrees]
    int width;
    int height;
    bool marched;
    TableKind tables;
    int steps;
    int sky_steps;
    Settings settings;
    World world;
    std::string height_map;
    double step_east;   ///< [m]
    double step_north;  ///< [m]
    std::string output;
    std::string shaders;                   ///< folder of the example's own; empty for the one of the sources
    std::optional<SequenceKind> sequence;  ///< instead of single pictures
    int frames;
    double latitude;  ///< [degrees] of the place where a day passes, or the window's sun
    std::optional<double> exposure;
    bool difference;
    std::optional<double> tolerance;  ///< of the largest relative difference
};

/// What --scene may be.
inline const std::vector<std::string>& scene_names() {
    static const std::vector<std::string> names = {"planet", "habitat"};
    return names;
}

/// Whether the command line asks for the habitat, which has options of its own: habitat/options.hpp.
bool asks_for_habitat(int count, char** arguments);

/// The options, or nothing when --help was asked for and is printed. Throws support::Error.
std::optional<Options> parse_options(int count, char** arguments);

}  // namespace deferred
