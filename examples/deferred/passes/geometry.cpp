#include "geometry.hpp"

#include <cstddef>

namespace deferred {
Geometry::Geometry(const World& world, const Terrain& terrain, bool objects)
    : world_(world), terrain_(terrain), objects_(objects) {
    terrain_triangles_ = make_triangles(sizeof(TerrainVertex), {{3, offsetof(TerrainVertex, position)},
                                                                {3, offsetof(TerrainVertex, normal)},
                                                                {1, offsetof(TerrainVertex, height)}});
    // The roughness follows the albedo, as one attribute of four.
    object_triangles_ = make_triangles(sizeof(ObjectVertex), {{3, offsetof(ObjectVertex, position)},
                                                              {3, offsetof(ObjectVertex, normal)},
                                                              {4, offsetof(ObjectVertex, albedo)}});
}

void Geometry::place(const View& view) {
    if (placed_ && camera_position_ == view.position) {
        return;
    }
    placed_ = true;
    camera_position_ = view.position;
    const double ground_radius = double(world_.atmosphere.ground_radius);
    upload(terrain_triangles_, terrain_.mesh(ground_radius, view.position));
    if (objects_) {
        upload(object_triangles_, object_mesh(terrain_, ground_radius, view.position));
    }
}

void Geometry::draw_terrain() const {
    deferred::draw(terrain_triangles_);
}

void Geometry::draw_objects() const {
    if (object_triangles_.index_count > 0) {
        deferred::draw(object_triangles_);
    }
}

}  // namespace deferred
