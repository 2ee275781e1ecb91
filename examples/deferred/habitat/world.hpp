#pragma once

#include <string>
#include <vector>

#include <airlight/habitats.hpp>

#include "frame.hpp"

namespace deferred::habitat {

/// How the air's light comes from the strips.
enum class AirLight {
    phase,   ///< strip_scattering for each strip: with phase functions, no table
    nodes,   ///< habitat_scattering_by_nodes: evenly to all sides, by the table of what passes
    marched  ///< habitat_scattering_marched: evenly to all sides, 30 steps through the document's table
};

/// Their names on the command line, in that order.
inline const std::vector<std::string>& air_light_names() {
    static const std::vector<std::string> names = {"phase", "nodes", "marched"};
    return names;
}

inline constexpr int march_steps = 30;  // the document's

/// A cylinder with its air, lights and land.
struct World {
    airlight::HabitatAir<float> air;
    airlight::HabitatLights<float> lights;
    vec3 wall_albedo;  ///< of the land in the mean, for light that bounces
    AirLight air_light;
    int bounces;  ///< of indirect light; 0 for none
};

/// Where a camera stands and looks.
struct Camera {
    std::string name;
    double along;          ///< [m] of the axis, from the middle
    double around;         ///< [degrees] about the axis, from the first strip
    double height;         ///< [m] above the land
    double heading;        ///< [degrees] from the direction of the axis, towards where `around` grows
    double pitch;          ///< [degrees] up, to the axis
    double field_of_view;  ///< [degrees] from the lower to the upper edge
};

/// The cameras with a name, in a cylinder of the default size; in others heights and ways are as much larger.
inline const std::vector<Camera>& named_cameras() {
    static const std::vector<Camera> cameras = {
        {"axis", -17e3, 60, 7400, 0, -2, 75},
        {"wall", -2e3, 62, 60, 8, 22, 70},
        {"cap", 3e3, 55, 900, 0, 16, 55},
        {"strip", 4.4e3, 1.6, 40, -12, 4, 60},
    };
    return cameras;
}

}  // namespace deferred::habitat
