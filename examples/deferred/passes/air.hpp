#pragma once

#include <optional>

#include "clouds.hpp"
#include "lighting.hpp"
#include "pass.hpp"
#include "surfaces.hpp"
#include "tables.hpp"
#include "world.hpp"

namespace deferred {

/// The air in front of everything: takes light from what is behind it, adds its own, less what shadows keep
/// from it.
class AirPass {
  public:
    AirPass(const World& world, const GpuTables& tables, int width, int height, bool clouds);

    /// `lost` is the texture of light that shadows keep from the air, 0 for none.
    void draw(const SurfacePass& surfaces, const LightingPass& lighting, GLuint lost,
              const std::optional<CloudPass>& clouds);

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
