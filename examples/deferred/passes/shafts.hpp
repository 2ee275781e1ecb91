#pragma once

#include "pass.hpp"
#include "settings.hpp"
#include "shadows.hpp"
#include "surfaces.hpp"
#include "world.hpp"

namespace deferred {

/// Light shafts: the light that shadows keep from the air in front of each pixel, by looks at the shadow maps
/// along its ray. At half the resolution it is brought up along edges of depth.
/// As a reference the same in hundreds of even steps, for each pixel by itself.
class ShaftPass {
  public:
    ShaftPass(const World& world, int width, int height, bool half);

    void draw(const SurfacePass& surfaces, const ShadowPass& shadows, const Settings& settings);

    GLuint lost() const {
        return lost_;
    }

  private:
    int width_;
    int height_;
    int march_width_;
    int march_height_;
    support::Texture marched_;  // with the distance of the surface it was marched to
    support::Texture lost_;
    support::Framebuffer marched_target_;
    support::Framebuffer lost_target_;
    support::Program march_program_;
    support::Program reference_program_;
    support::Program gather_program_;
};

}  // namespace deferred
