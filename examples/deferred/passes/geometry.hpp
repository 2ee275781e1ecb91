#pragma once

#include "objects.hpp"
#include "terrain.hpp"
#include "triangles.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

/// Triangles on the GPU, with positions relative to a camera: what the G-buffer and the shadow maps are drawn
/// from.
class Geometry {
  public:
    Geometry(const World& world, const Terrain& terrain, bool objects);

    /// Moves everything to where this camera sees it. Does nothing when the camera has not moved.
    void place(const View& view);

    void draw_terrain() const;

    /// Nothing when the scene has no objects.
    void draw_objects() const;

  private:
    const World& world_;
    const Terrain& terrain_;
    bool objects_;
    bool placed_ = false;
    glm::dvec3 camera_position_{};
    Triangles terrain_triangles_;
    Triangles object_triangles_;
};

}  // namespace deferred
