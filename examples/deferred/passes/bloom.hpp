#pragma once

#include <vector>

#include "pass.hpp"

namespace deferred {

/// Light that spreads in eye and lens: a share of each pixel's, over ever wider surroundings. No threshold,
/// and none is gained or lost. In 32-bit float: a half holds neither the sun beside a night nor the night.
class BloomPass {
  public:
    /// A level of the pyramid: half the size of the one below it, rounded up.
    struct Level {
        int width;
        int height;
        support::Texture reduced;  ///< the radiance at this size
        support::Texture glow;     ///< with that of all coarser levels; none at the coarsest
        support::Framebuffer reduced_target;
        support::Framebuffer glow_target;
    };

    /// The share of a pixel's light that spreads.
    static constexpr float share = 0.01f;

    BloomPass(int width, int height);

    /// Reduces a picture of linear radiance to every level: what both glow and flare are made of.
    void reduce(GLuint radiance);

    /// The levels together, finest last.
    void spread();

    /// The finest first; at least one.
    const std::vector<Level>& levels() const {
        return levels_;
    }

    /// What spread() made, at half the picture's size.
    GLuint glow() const {
        return levels_.size() > 1 ? levels_.front().glow : levels_.front().reduced;
    }

  private:
    std::vector<Level> levels_;
    support::Program down_program_;
    support::Program up_program_;
};

}  // namespace deferred
