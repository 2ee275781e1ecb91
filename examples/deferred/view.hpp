#pragma once

#include <string>
#include <vector>

#include "frame.hpp"
#include "settings.hpp"
#include "terrain.hpp"

namespace deferred {

/// Where a camera stands and looks, in the terms of the command line.
struct Camera {
    std::string name;
    double east;           ///< [m] of the landscape's centre, along the ground
    double north;          ///< [m]
    double altitude;       ///< [m] above the ground sphere, or above the landscape
    bool above_landscape;  ///< what `altitude` counts from
    double heading;        ///< [degrees] clockwise from north
    double pitch;          ///< [degrees] up from the horizontal
    double field_of_view;  ///< [degrees] from the lower to the upper edge
};

/// The cameras with a name.
const std::vector<Camera>& named_cameras();

/// What a picture of the landscape is made with, apart from the camera.
struct Picturing {
    int width;
    int height;
    double sun_elevation;  ///< [degrees] above the horizontal under the camera
    double sun_azimuth;    ///< [degrees] clockwise from north
    bool marched;          ///< the air in steps, not by nodes
    int steps;             ///< of the air between the eye and the surface
    int sky_steps;         ///< of the sky above a surface, for its skylight
    Settings settings;
};

/// A camera as the passes need it: positions relative to it.
struct View {
    glm::dvec3 position;  ///< [m] from the landscape's centre at altitude 0
    double altitude;      ///< [m] above the ground sphere
    double above_ground;  ///< [m] above the landscape
    Frame frame;
};

/// Gives a frame its rays, and its nearest distance: of a camera that looks along `forward`, its upper edge
/// towards `up`.
void aim(Frame& frame, const glm::dvec3& forward, const glm::dvec3& up, double field_of_view, int width,
         int height);

/// Throws support::Error when the camera is below the ground.
View make_view(const Camera& camera, const Picturing& picturing, double ground_radius,
               const Terrain& terrain);

}  // namespace deferred
