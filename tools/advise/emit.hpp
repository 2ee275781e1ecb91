#pragma once

// A setting as source text.

#include <string>
#include <vector>

#include "setting.hpp"

namespace advise {

/// The names of the absorbing layer's profiles and of the aerosol's phase functions, in the order of their
/// numbers in airlight/scene.hpp.
const std::vector<std::string>& ozone_names();
const std::vector<std::string>& phase_names();

/// `struct name : airlight::DefaultScene` with every flag, under `comment`'s lines.
std::string cpp_text(const Setting& setting, const std::string& name, const std::string& comment);

/// The macros to stand before airlight.glsl is included, under `comment`'s lines.
std::string glsl_text(const Setting& setting, const std::string& comment);

}  // namespace advise
