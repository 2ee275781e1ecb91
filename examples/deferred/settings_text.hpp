#pragma once

#include <string>

#include "world.hpp"

// What was found in the window, for a program of one's own.

namespace deferred {

/// The scene's terms and the air as C++ that includes airlight/airlight.hpp.
std::string as_cpp(const World& world);

/// The same as GLSL: lines before the include of airlight.glsl and the air after it.
std::string as_glsl(const World& world);

}  // namespace deferred
