#pragma once

#include "habitat/options.hpp"

namespace deferred::habitat {

/// Draws a picture for each camera; with `difference` compares it with the CPU's, with `truth` writes what a
/// path tracer makes of the same surfaces. Throws support::Error.
void draw_pictures(const Options& options);

}  // namespace deferred::habitat
