#pragma once

#include "geometry.hpp"
#include "pass.hpp"
#include "terrain.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

/// The G-buffer: what is seen through each pixel, and how far away it is.
class SurfacePass {
  public:
    SurfacePass(const World& world, int width, int height);

    /// Draws the world's surfaces. Depth is reversed: near_distance / distance along the view axis, 0 where
    /// there is no surface.
    void draw(const Geometry& geometry);

    GLuint depth() const {
        return depth_;
    }
    GLuint albedo() const {
        return albedo_;
    }  ///< and roughness in its fourth channel
    GLuint normal() const {
        return normal_;
    }
    GLuint target() const {
        return target_;
    }

  private:
    const World& world_;
    int width_;
    int height_;
    support::Texture depth_;
    support::Texture albedo_;
    support::Texture normal_;
    support::Framebuffer target_;
    support::Program terrain_program_;
    support::Program object_program_;
    support::Program planet_program_;
};

}  // namespace deferred
