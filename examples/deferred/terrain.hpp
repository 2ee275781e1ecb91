#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

namespace deferred {

/// Elevations on a grid, north row first, west column first.
struct HeightMap {
    int columns;
    int rows;
    double step_east;            ///< [m] between columns
    double step_north;           ///< [m] between rows
    std::vector<float> heights;  ///< [m] above the ground sphere
};

/// Reads a grey PNG of 8 or 16 bits, one metre a grey level, or the first channel of an OpenEXR file, in
/// metres. Throws support::Error when the file is unreadable, damaged or smaller than 2 x 2.
HeightMap read_height_map(const std::filesystem::path& path, double step_east, double step_north);

/// A point on or above the ground sphere, and its local directions. Measured from the landscape's centre at
/// altitude 0, where x is east, y north and z up. In double: the planet's centre appears nowhere else.
struct Place {
    glm::dvec3 position;  ///< [m]
    glm::dvec3 east;
    glm::dvec3 north;
    glm::dvec3 up;
};

/// The place `east` and `north` of the landscape's centre, measured along the ground, at `altitude` [m].
Place place_on_sphere(double ground_radius, double east, double north, double altitude);

/// One corner of the landscape's triangles.
struct TerrainVertex {
    glm::vec3 position;  ///< [m] from the camera
    glm::vec3 normal;
    float height;  ///< [m] above the ground sphere
};

struct TerrainMesh {
    std::vector<TerrainVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle
};

/// A height map laid on the ground sphere. Around it lies a margin in which its mirror image sinks to the
/// ground sphere, so that the landscape meets the planet without a step.
class Terrain {
  public:
    explicit Terrain(HeightMap map);

    /// Height of the ground above the sphere [m], `east` and `north` of the centre [m].
    double height(double east, double north) const;

    /// All of it lies within this distance of its centre [m].
    double radius() const;

    /// The triangles, with positions relative to a camera.
    TerrainMesh mesh(double ground_radius, const glm::dvec3& camera_position) const;

  private:
    double grid_height(int column, int row) const;

    HeightMap map_;
    int margin_columns_;
    int margin_rows_;
};

}  // namespace deferred
