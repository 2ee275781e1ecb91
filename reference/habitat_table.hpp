#pragma once

// The rays through a habitat that its approximations are judged by, traced into a table.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "habitat.hpp"

namespace reference {

/// A ray from an eye to the wall or a cap.
struct HabitatRay {
    std::string kind;  ///< where the eye is and where it looks
    Vector eye;
    Vector direction;
    double distance = 0;  ///< [m] to the wall
};

/// 64 rays through the library's habitat: from everywhere, from within 100 m of the wall, on the axis, within
/// 4 widths of a strip; everywhere, towards strips and along them.
std::vector<HabitatRay> judged_habitat_rays(const Habitat& habitat);

/// Traces them: light of the air scattered once, with all orders, and once without phase functions, and the
/// irradiance of the wall where they end, each with its standard error. `walks` for what has all orders, in
/// each colour, twice as many for the rest.
void write_habitat_table(const Habitat& habitat, std::uint64_t walks, std::uint64_t seed,
                         const std::filesystem::path& path);

}  // namespace reference
