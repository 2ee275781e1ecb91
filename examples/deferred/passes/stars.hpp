#pragma once

#include "pass.hpp"

namespace deferred {

/// A field of stars into the G-buffer's albedo, where there is no surface, in units of one of magnitude 0. As
/// many of each brightness as the real sky has, in directions of chance.
class StarPass {
  public:
    StarPass(int width, int height);

    /// Adds to the target of SurfacePass.
    void draw(GLuint target) const;

  private:
    int width_;
    int height_;
    int count_;
    support::Buffer buffer_;
    support::VertexArray array_;
    support::Program program_;
};

}  // namespace deferred
