#pragma once

#include "options.hpp"

namespace deferred {

/// The pictures of a flight, a day or a turn as frame_0000.png and so on, with a bar for the progress.
void draw_sequence(const Options& options);

}  // namespace deferred
