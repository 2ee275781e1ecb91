#pragma once

#include "pass.hpp"
#include "shadows.hpp"
#include "surfaces.hpp"

namespace deferred {

/// How much of the sun and of the sky each pixel's surface sees.
class VisibilityPass {
  public:
    VisibilityPass(int width, int height, bool clouds);

    /// `sky_share` is the texture of OcclusionPass, 0 for an open sky everywhere.
    void draw(const SurfacePass& surfaces, const ShadowPass& shadows, GLuint sky_share);

    /// Share of the sun, share of the sky, number of the cascade that told (4 for none).
    GLuint shares() const {
        return shares_;
    }

  private:
    int width_;
    int height_;
    support::Texture shares_;
    support::Framebuffer target_;
    support::Program program_;
};

}  // namespace deferred
