#pragma once

#include "terrain.hpp"
#include "view.hpp"

// How the eye and the sun move in a window.

namespace deferred {

/// What the keys ask for: each from -1 to 1.
struct Steering {
    double forward;
    double right;
    double up;
    double haste;  ///< factor of the speed
};

/// The camera after some seconds of flight, its height above the ground sphere from then on. Its speed is its
/// height above the ground each second, and it stays above the ground.
Camera flown(const Camera& camera, const Steering& steering, double seconds, double ground_radius,
             const Terrain& terrain);

/// The camera turned by degrees.
Camera turned(const Camera& camera, double right, double up);

/// A direction in the sky.
struct SkyPlace {
    double elevation;  ///< [degrees]
    double azimuth;    ///< [degrees] clockwise from north
};

/// Where the sun is so many hours later, at a latitude [degrees].
SkyPlace hours_later(const SkyPlace& sun, double hours, double latitude);

}  // namespace deferred
