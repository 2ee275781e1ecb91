#pragma once

#include <vector>

#include "frame.hpp"
#include "renderer.hpp"
#include "tables.hpp"
#include "world.hpp"

namespace deferred {

/// The pass of light and air over the GPU's surfaces, by the C++ headers in float, on every core: 3 per
/// pixel, the lower row first.
std::vector<float> light_on_cpu(const World& world, const AirTables& tables, const Frame& frame,
                                const GBuffer& surfaces);

/// Which pixels show the sun's disc or the moon's, wholly or in part; the lower row first.
std::vector<bool> disc_pixels(const Frame& frame, const GBuffer& surfaces);

}  // namespace deferred
