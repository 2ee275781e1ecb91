#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "terrain.hpp"

namespace deferred {

/// One corner of an object's triangles.
struct ObjectVertex {
    glm::vec3 position;  ///< [m] from the camera
    glm::vec3 normal;
    glm::vec3 albedo;
    float roughness;  ///< as Surface has it
};

struct ObjectMesh {
    std::vector<ObjectVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle
};

/// Things that stand in the landscape and fly above it, made by code: a row of slabs and an arch in the
/// valley, which throw shafts of shadow; in orbit a station in front of the air and a ball in front of space.
/// Positions are relative to a camera. What is too far away to fill a pixel is left out.
ObjectMesh object_mesh(const Terrain& terrain, double ground_radius, const glm::dvec3& camera_position);

}  // namespace deferred
