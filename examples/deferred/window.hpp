#pragma once

#include "options.hpp"

namespace deferred {

/// The front with a window: the same renderer, with everything to turn and to fly through. Returns when the
/// window is closed. Throws support::Error in one line when there is no display, no OpenGL 4.3 on it, or no
/// window in this build.
void run_window(const Options& options);

}  // namespace deferred
