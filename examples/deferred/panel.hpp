#pragma once

#include <optional>
#include <string>
#include <vector>

#include "passes/difference.hpp"
#include "passes/timer.hpp"
#include "settings.hpp"
#include "tables.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

/// What a picture is compared with.
enum class Reference { none, fine, cpu };

/// Everything that the window lets one change.
struct Controls {
    World world;
    TableKind tables;
    Settings settings;
    Camera camera;
    double sun_elevation;  ///< [degrees] above the horizontal under the camera
    double sun_azimuth;    ///< [degrees] clockwise from north
    bool marched;
    int steps;
    int sky_steps;
    bool automatic_exposure;
    float exposure;
    bool sun_moves = false;
    float sun_speed = 1;  ///< hours a second
    bool riding = false;
    bool ride_pauses = false;  ///< held at its place
    float ride = 0;            ///< share of the way into space
    int coarseness = 1;        ///< pixels of the window each way that share one of the picture
    Reference reference = Reference::none;
    bool panel = true;
};

/// What the panel tells.
struct Status {
    std::string driver;
    std::string error;  ///< of the last reload of the shaders; "" when all is well
    std::string note;   ///< what was done last
    std::string reference;
    std::optional<double> baked;  ///< share, while tables are baked
    double frame_seconds;
    double altitude;
    int width;
    int height;
    std::vector<PassTime> times;
};

/// What the panel was asked for.
struct Wishes {
    bool changed = false;  ///< the picture
    bool rebuild = false;  ///< a change that passes are made with
    bool air = false;      ///< another air, which tables are to be baked for
    bool reload = false;
    bool screenshot = false;
    bool copy_cpp = false;
    bool copy_glsl = false;
};

/// The colours of differences from this reference.
DifferenceScale scale_of(Reference reference);

/// Draws the panel into the current frame of Dear ImGui.
Wishes draw_panel(Controls& controls, const Status& status);

}  // namespace deferred
