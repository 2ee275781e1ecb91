#pragma once

#include "options.hpp"

namespace deferred {

/// Each camera with each sun elevation: an OpenEXR file, a PNG and how far GPU and CPU are apart.
void draw_pictures(const Options& options);

}  // namespace deferred
