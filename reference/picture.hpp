#pragma once

#include <filesystem>

#include "views.hpp"

namespace reference {

/// Traces a panorama, azimuth -180 to 180 degrees around the sun and the zenith in the top row, and writes it
/// as OpenEXR: the total, its standard error ("error.R"), and the light of the first orders ("order_1.R").
void write_picture(const support::Preset& preset, const View& eye, double sun_diameter, int width,
                   const Effort& effort, const std::filesystem::path& path);

}  // namespace reference
