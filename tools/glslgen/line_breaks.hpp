#pragma once

#include <vector>

#include "layout.hpp"

namespace glslgen {

/// Breaks lines that the prefixes of GLSL made longer than 110 characters: behind a comma, going on below the
/// first argument, together with what the author had put on the next line.
std::vector<Line> break_long_lines(const std::vector<Line>& lines);

}  // namespace glslgen
