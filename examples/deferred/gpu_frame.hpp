#pragma once

#include <cstdint>
#include <vector>

#include "support/gl_objects.hpp"
#include "tables.hpp"
#include "terrain.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

/// What the first pass leaves for each pixel. The lower row first, as OpenGL has it.
struct GBuffer {
    std::vector<float> depth;   ///< reversed: near_distance / distance along the view axis
    std::vector<float> albedo;  ///< 4 per pixel: red, green, blue, roughness
    std::vector<float> normal;  ///< 4 per pixel: x, y, z, unused
};

/// A picture as the GPU made it, the lower row first.
struct GpuPicture {
    GBuffer surfaces;
    std::vector<float> radiance;  ///< 3 per pixel, in units of solar_irradiance per sr
    double milliseconds;          ///< the pass of light and air took
};

/// Draws a world and its landscape. Needs an OpenGL 4.3 context that is current.
class GpuRenderer {
  public:
    GpuRenderer(const World& world, const AirTables& tables, const Terrain& terrain, int width, int height);

    /// Whether the driver has depth from 0 to 1 before rasterisation (ARB_clip_control, OpenGL 4.5). Without
    /// it the projection maps to [-1, 1], and reversed depth keeps its digits as gl_FragDepth only.
    bool has_clip_control() const {
        return has_clip_control_;
    }

    GpuPicture draw(const View& view);

    /// The last picture, exposed and encoded as sRGB on the GPU: 3 bytes per pixel, the lower row first.
    std::vector<std::uint8_t> display(float exposure);

  private:
    void draw_surfaces(const View& view);

    const World& world_;
    const Terrain& terrain_;
    int width_;
    int height_;
    bool has_clip_control_;
    GpuTables tables_;

    support::Texture depth_;
    support::Texture albedo_;
    support::Texture normal_;
    support::Texture radiance_;
    support::Texture encoded_;
    support::Framebuffer surfaces_target_;
    support::Framebuffer radiance_target_;
    support::Framebuffer encoded_target_;
    support::Program terrain_program_;
    support::Program planet_program_;
    support::Program lighting_program_;
    support::Program display_program_;
    support::Buffer vertices_;
    support::Buffer indices_;
    support::VertexArray terrain_array_;
    support::VertexArray screen_array_;
};

}  // namespace deferred
