#pragma once

#include <cstdint>
#include <vector>

#include "blocks.hpp"
#include "gpu_picture.hpp"
#include "habitat/land.hpp"
#include "habitat/shading.hpp"
#include "passes/bloom.hpp"
#include "passes/flare.hpp"
#include "passes/pass.hpp"
#include "passes/timer.hpp"
#include "passes/tone.hpp"
#include "passes/triangles.hpp"
#include "settings.hpp"

namespace deferred::habitat {

/// Bakes what the world's light needs, on all cores and with bars.
Tables bake_tables(const World& world);

/// Draws the inside of a habitat: its land into a G-buffer, then light and air, then bloom and tone. Needs an
/// OpenGL 4.3 context that is current.
class HabitatRenderer {
  public:
    HabitatRenderer(const World& world, const Tables& tables, const Land& land, bool plain, int width,
                    int height);

    /// Land, light and air.
    void draw(const Frame& frame);

    /// What draw() left, with its G-buffer; roughness is the strips' share of a pixel.
    GpuPicture read() const;

    /// Other radiance, 3 per pixel, in place of what draw() left.
    void replace(const std::vector<float>& radiance);

    /// The last passes, see Renderer::display.
    std::vector<std::uint8_t> display(const Settings& settings, float exposure);

    PassTimers& timers() {
        return timers_;
    }

  private:
    void set_world(const support::Uniforms& program) const;

    const World& world_;
    bool plain_;
    int width_;
    int height_;
    BlockBuffer<Frame> frame_block_;
    Triangles land_;
    support::Texture straight_table_;
    support::Texture mean_table_;
    support::Texture irradiance_table_;
    support::Texture depth_;
    support::Texture albedo_;
    support::Texture normal_;
    support::Texture radiance_;
    support::Framebuffer surface_target_;
    support::Framebuffer light_target_;
    support::Program land_program_;
    support::Program light_program_;
    BloomPass bloom_;
    FlarePass flare_;
    TonePass tone_;
    mutable PassTimers timers_;
};

}  // namespace deferred::habitat
