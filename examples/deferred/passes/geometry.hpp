#pragma once

#include "pass.hpp"
#include "terrain.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

/// Triangles on the GPU, with positions relative to a camera: what the G-buffer and the shadow maps are drawn
/// from.
class Geometry {
  public:
    Geometry(const World& world, const Terrain& terrain);

    /// Moves everything to where this camera sees it. Does nothing when the camera has not moved.
    void place(const View& view);

    void draw_terrain() const;

  private:
    const World& world_;
    const Terrain& terrain_;
    bool placed_ = false;
    glm::dvec3 camera_position_{};
    int index_count_ = 0;
    support::Buffer vertices_;
    support::Buffer indices_;
    support::VertexArray array_;
};

}  // namespace deferred
