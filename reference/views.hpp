#pragma once

// What is looked at from where.

#include <string>
#include <vector>

#include "support/presets.hpp"
#include "walk.hpp"

namespace reference {

/// A view over level ground; angles in degrees.
struct View {
    double altitude = 2;        ///< [m] of the eye
    double sun_elevation = 30;  ///< over the horizontal
    double elevation = 90;      ///< of the view ray
    double azimuth = 0;         ///< of the view ray, from the sun's

    /// "2 m; sun -3; view 30 / 90".
    std::string name() const;
};

/// The unit vector at angles in degrees: elevation over the horizontal, azimuth from the sun's.
Vector direction_at(double elevation, double azimuth = 0);

/// A view in one channel of an atmosphere.
Radiance traced(const Air& air, const View& view, double sun_diameter, const Effort& effort);

/// 66 views that stand for what an atmosphere is judged by: the sky from the ground with the sun from high to
/// 12 degrees below the horizon, from 10 km, the disc and the limb from an orbit, and the lower sky between
/// the sun's azimuth and the opposite.
std::vector<View> judged_views();

}  // namespace reference
