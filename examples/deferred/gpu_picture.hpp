#pragma once

#include <vector>

namespace deferred {

/// What the passes before the light leave for each pixel. The lower row first, as OpenGL has it.
struct GBuffer {
    std::vector<float> depth;   ///< reversed: near_distance / distance along the view axis
    std::vector<float> albedo;  ///< 4 per pixel: red, green, blue, roughness; stars where there is no surface
    std::vector<float> normal;  ///< 4 per pixel: x, y, z, unused
    std::vector<float> shares;  ///< 4 per pixel: of the sun, of the sky, the cascade's number, unused
    std::vector<float> lost;    ///< 3 per pixel: light that shadows keep from the air; empty without shafts
    std::vector<float> clouds;  ///< 4 per pixel: their light, what they let through; empty without clouds
    std::vector<float> cloud_distance;  ///< [m]
};

/// A picture as the GPU made it, the lower row first.
struct GpuPicture {
    GBuffer surfaces;
    std::vector<float> radiance;  ///< 3 per pixel, in units of solar_irradiance per sr
    double milliseconds;          ///< light and air took
    double shaft_milliseconds;    ///< and of that the shafts
};

}  // namespace deferred
