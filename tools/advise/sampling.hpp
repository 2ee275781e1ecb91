#pragma once

// The views that a scene may show, drawn from a seed.

#include <cstdint>
#include <vector>

#include "evaluate.hpp"

namespace advise {

struct Range {
    double low;
    double high;
};

/// Where the cameras are, where the sun, how far they see.
struct Ranges {
    Range height{0, 1000};     ///< [m] over the ground sphere
    Range sun{0, 90};          ///< [degrees] over the camera's horizontal plane
    Range distance{10, 20e3};  ///< [m] of the surfaces; infinite for views that end on none
};

/// Rays over the ranges: stratified in each of them, both ends included, and between looking up, at the
/// horizon, down, and close to the sun. The same from the same seed, with every standard library. An eye
/// above the air looks at the limb instead of up.
std::vector<View> sampled(const Atmosphere& air, const Ranges& ranges, int count, std::uint64_t seed);

/// The view whose luminance is the measure of what counts as dark: from 2 m to the zenith, the sun there.
View noon_zenith();

/// By how much the horizon lies below the horizontal plane of an eye [degrees].
double horizon_dip(const Atmosphere& air, double altitude);

}  // namespace advise
