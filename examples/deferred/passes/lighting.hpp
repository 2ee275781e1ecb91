#pragma once

#include "pass.hpp"
#include "surfaces.hpp"
#include "tables.hpp"
#include "visibility.hpp"
#include "world.hpp"

namespace deferred {

/// Light that leaves the surfaces towards the eye, and that of the sun, the moon and the stars: all as if
/// there were no air between them and the eye.
class LightingPass {
  public:
    LightingPass(const World& world, const GpuTables& tables, int width, int height);

    void draw(const SurfacePass& surfaces, const VisibilityPass& visibility);

    GLuint radiance() const {
        return radiance_;
    }

  private:
    const GpuTables& tables_;
    int width_;
    int height_;
    support::Texture radiance_;
    support::Framebuffer target_;
    support::Program program_;
};

}  // namespace deferred
