#pragma once

// Atmospheres by the name of a preset, or from a text file. README.md describes the format.

#include <string>
#include <vector>

#include "evaluate.hpp"

namespace advise {

/// An atmosphere and the profile of its absorbing layer.
struct Air {
    Atmosphere atmosphere;
    int ozone;
};

/// The names that preset() knows.
std::vector<std::string> preset_names();

/// One of airlight's presets. Throws support::Error for a name that is none.
Air preset(const std::string& name);

/// The atmosphere that a text describes; `file` is what errors call it. Throws support::Error with
/// file:line for a line that is none, and with the names for members that are missing.
Atmosphere parsed_atmosphere(const std::string& text, const std::string& file);

}  // namespace advise
