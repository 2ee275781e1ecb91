#pragma once

#include <string>
#include <vector>

#include "view.hpp"

namespace deferred {

/// What changes from picture to picture of a sequence.
enum class SequenceKind { flight, day, turntable };

/// Their names on the command line, in that order.
const std::vector<std::string>& sequence_names();

/// One picture of a sequence: where the camera is, where the sun.
struct Moment {
    Camera camera;
    double sun_elevation;  ///< [degrees] above the horizontal under the camera
    double sun_azimuth;    ///< [degrees] clockwise from north
};

/// From 1 m above the landscape to 1e8 m, each picture higher than the last by the same factor. From 100 m on
/// the camera backs away from where it started and looks back there: at the hills, then down on the landscape
/// and the limb behind it, at last at the whole planet. The sun stands still over the landscape.
std::vector<Moment> flight(int frames, const Moment& start, double ground_radius);

/// 24 hours from midnight at an equinox: the sun rises in the east and at noon stands as far from the zenith
/// as the place is from the equator.
std::vector<Moment> day(int frames, const Camera& camera, double latitude);

/// The camera turns clockwise, once around.
std::vector<Moment> turntable(int frames, const Moment& start);

}  // namespace deferred
