#pragma once

#include "bloom.hpp"
#include "pass.hpp"

namespace deferred {

/// Lens flare: ghosts and a ring of what is far brighter than anything the sun lights, from the bloom's
/// pyramid. Nothing when there is none.
class FlarePass {
  public:
    explicit FlarePass(const BloomPass& bloom);

    /// From what BloomPass::reduce() made.
    void draw(const BloomPass& bloom);

    /// Radiance to add; a texture of half the picture's size, to be read between its texels.
    GLuint radiance() const {
        return flare_;
    }

  private:
    std::size_t level_ = 0;  // of the pyramid, that the bright parts are taken from
    support::Texture bright_;
    support::Texture flare_;
    support::Framebuffer bright_target_;
    support::Framebuffer flare_target_;
    support::Program bright_program_;
    support::Program ghosts_program_;
};

}  // namespace deferred
