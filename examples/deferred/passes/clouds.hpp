#pragma once

#include "pass.hpp"
#include "surfaces.hpp"
#include "tables.hpp"
#include "world.hpp"

namespace deferred {

/// A layer of clouds in front of the surfaces: its own light, what it lets through, and its distance. The air
/// between eye, clouds and surfaces is AirPass's.
class CloudPass {
  public:
    CloudPass(const World& world, const GpuTables& tables, int width, int height);

    void draw(const SurfacePass& surfaces);

    /// Light by unit solar irradiance [1/sr], and transmittance.
    GLuint light() const {
        return light_;
    }
    /// Mean distance of what is seen of them [m].
    GLuint distance() const {
        return distance_;
    }

  private:
    const GpuTables& tables_;
    int width_;
    int height_;
    support::Texture light_;
    support::Texture distance_;
    support::Framebuffer target_;
    support::Program program_;
};

}  // namespace deferred
