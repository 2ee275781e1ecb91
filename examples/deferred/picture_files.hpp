#pragma once

#include <cstdint>
#include <vector>

#include "frame.hpp"
#include "renderer.hpp"
#include "support/image.hpp"

// What becomes of a picture that the GPU made. OpenGL has the lower row first, files the upper.

namespace deferred {

/// Radiance and G-buffer as the layers of an OpenEXR file.
support::ExrImage layers(const GpuPicture& picture, const Frame& frame);

/// Bytes of a display, 3 per pixel, as a picture.
support::Picture upright(const std::vector<std::uint8_t>& pixels, int width, int height);

/// Brings the middle of what is lit to the middle of the display's scale. `disc` is left out.
float automatic_exposure(const std::vector<float>& radiance, const std::vector<bool>& disc);

}  // namespace deferred
