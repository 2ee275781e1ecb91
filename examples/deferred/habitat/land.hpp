#pragma once

#include <cstdint>
#include <vector>

#include <airlight/habitat_mapping.hpp>
#include <glm/glm.hpp>

#include "terrain.hpp"

namespace deferred::habitat {

/// One corner of the land's triangles.
struct LandVertex {
    glm::vec3 position;  ///< [m] from the cylinder's middle
    glm::vec3 normal;
    float height;  ///< [m] above the wall
};

struct LandMesh {
    std::vector<LandVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle
};

/// A height map laid on the wall of a cylinder, there and back again around it and along it, so that it has
/// no seam; flat beside the strips of light, and with it the two caps.
class Land {
  public:
    /// A plain has no heights. Throws support::Error when the heights do not fit into the cylinder.
    Land(HeightMap map, double radius, const airlight::HabitatLights<float>& lights, bool plain);

    /// Height above the wall [m], `along` the axis [m] and `around` it [rad].
    double height(double along, double around) const;

    LandMesh mesh() const;

    double radius() const {
        return radius_;
    }

  private:
    HeightMap map_;
    double lowest_;
    bool plain_;
    double radius_;
    airlight::HabitatLights<float> lights_;
};

}  // namespace deferred::habitat
