#pragma once

#include "pass.hpp"

namespace deferred {

/// Colours of differences: black, blue, green, red, white, each `decades` above the one before.
struct DifferenceScale {
    float blue_at;  ///< logarithm to the base 10 of the relative difference
    float decades;
};

/// How far a picture is from a reference, in false colours: the worst channel of each pixel.
class DifferencePass {
  public:
    DifferencePass(int width, int height);

    /// Differences are relative to the reference's value, or to `floor` where that is less.
    void draw(GLuint radiance, GLuint reference, float floor, const DifferenceScale& scale);

    /// The colours' framebuffer, to copy to a window.
    GLuint target() const {
        return target_;
    }

  private:
    int width_;
    int height_;
    support::Texture colors_;
    support::Framebuffer target_;
    support::Program program_;
};

}  // namespace deferred
