#pragma once

#include "pass.hpp"

namespace deferred {

/// How much of its sky each pixel's surface sees past what the screen shows around it. Each pixel looks along
/// few lines, its neighbours along others; then the mean of neighbours on the same surface.
class OcclusionPass {
  public:
    OcclusionPass(int width, int height);

    /// From the G-buffer's reversed depth and normals.
    void draw(GLuint depth, GLuint normal);

    /// Share of the sky, 1 where nothing hides any.
    GLuint share() const {
        return share_;
    }

  private:
    int width_;
    int height_;
    support::Texture noisy_;
    support::Texture share_;
    support::Framebuffer noisy_target_;
    support::Framebuffer share_target_;
    support::Program horizons_program_;
    support::Program mean_program_;
};

}  // namespace deferred
