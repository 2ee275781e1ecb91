#pragma once

#include <cstdint>
#include <vector>

#include "bloom.hpp"
#include "flare.hpp"
#include "pass.hpp"
#include "settings.hpp"

namespace deferred {

/// Radiance to the bytes of a display, last of all.
class TonePass {
  public:
    TonePass(int width, int height);

    /// `shares` are those of VisibilityPass. BloomPass and FlarePass have been drawn where the settings have
    /// them.
    void draw(GLuint radiance, GLuint shares, const BloomPass& bloom, const FlarePass& flare,
              const Settings& settings, float exposure);

    /// What was drawn last: 3 bytes per pixel, the lower row first.
    std::vector<std::uint8_t> read() const;

    /// The bytes' framebuffer, to copy to a window.
    GLuint target() const {
        return target_;
    }

  private:
    int width_;
    int height_;
    support::Texture encoded_;
    support::Framebuffer target_;
    support::Program program_;
};

}  // namespace deferred
