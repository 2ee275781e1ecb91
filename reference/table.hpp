#pragma once

#include <filesystem>
#include <string>

#include "views.hpp"

namespace reference {

/// Traces the judged views in three channels and writes a CSV: one line for each view and channel, with the
/// total, its standard error, and every order. Draws a progress bar.
void write_table(const support::Preset& preset, double sun_diameter, const Effort& effort,
                 const std::filesystem::path& path);

/// The irradiance of level ground by the sky, with the sun from high to 6 degrees below the horizon.
void write_irradiance_table(const support::Preset& preset, const Effort& effort,
                            const std::filesystem::path& path);

}  // namespace reference
