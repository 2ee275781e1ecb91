#pragma once

#include <string>

#include "model.hpp"

namespace glslgen {

/// Everything a program needs to call the GLSL, as JSON: constants, flags, hooks, structs, functions.
std::string manifest(const Program& program);

}  // namespace glslgen
