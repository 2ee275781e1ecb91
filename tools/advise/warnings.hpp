#pragma once

// What is suspicious about an atmosphere, about ranges, and about the light that was measured.

#include <string>
#include <vector>

#include "measure.hpp"
#include "sampling.hpp"

namespace advise {

/// Numbers that look like another unit, or layers that are not where the air is.
std::vector<std::string> warnings_of(const Atmosphere& air, const Setting& setting);

/// Cameras under ground, nights without end.
std::vector<std::string> warnings_of(const Atmosphere& air, const Ranges& ranges);

/// Light that a half float cannot hold, darkness, and layers that fall between the reference's nodes.
std::vector<std::string> warnings_of(const Measured& measured);

}  // namespace advise
