#include "terrain.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "support/error.hpp"
#include "support/image.hpp"

namespace deferred {
namespace {

constexpr double margin = 12e3;      // [m] wide enough for slopes of a few degrees down to the sphere
constexpr double skirt_depth = 100;  // [m] the mesh ends below the sphere, so that no gap can open

/// Index into 0 .. count - 1 of a sequence that goes there and back again without end.
int mirrored(int index, int count) {
    const int period = 2 * (count - 1);
    const int phase = ((index % period) + period) % period;
    return phase < count ? phase : period - phase;
}

double smooth(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

HeightMap read_height_map(const std::filesystem::path& path, double step_east, double step_north) {
    HeightMap map{0, 0, step_east, step_north, {}};
    if (path.extension() == ".exr") {
        const support::ExrImage image = support::read_exr(path);
        if (image.channels.empty()) {
            throw support::Error("height map '" + path.string() + "' has no channel; give one with heights");
        }
        map.columns = image.width;
        map.rows = image.height;
        map.heights = image.channels.front().pixels;
    } else {
        const support::GreyImage image = support::read_grey_png(path);
        map.columns = image.width;
        map.rows = image.height;
        map.heights.assign(image.pixels.begin(), image.pixels.end());
    }
    if (map.columns < 2 || map.rows < 2 || map.columns > 4096 || map.rows > 4096) {
        throw support::Error("height map '" + path.string() + "' is " + std::to_string(map.columns) + " x " +
                             std::to_string(map.rows) + "; it needs 2 to 4096 pixels each way");
    }
    const bool plausible = std::all_of(map.heights.begin(), map.heights.end(),
                                       [](float height) { return std::abs(height) <= 1e5f; });
    if (!plausible) {
        throw support::Error("height map '" + path.string() +
                             "' holds heights beyond 100 km or no numbers; give metres, without gaps");
    }
    return map;
}

Place place_on_sphere(double ground_radius, double east, double north, double altitude) {
    const double distance = std::hypot(east, north);
    const double angle = distance / ground_radius;
    const glm::dvec2 way = distance > 0 ? glm::dvec2(east, north) / distance : glm::dvec2(0, 1);
    const double half_sine = std::sin(angle / 2);
    const glm::dvec3 up(std::sin(angle) * way, std::cos(angle));

    Place place;
    // (R + h) up - R z, without the difference of two radii.
    place.position = glm::dvec3((ground_radius + altitude) * std::sin(angle) * way,
                                altitude * std::cos(angle) - 2 * ground_radius * half_sine * half_sine);
    place.up = up;
    place.east = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), up));
    place.north = glm::cross(up, place.east);
    return place;
}

Terrain::Terrain(HeightMap map)
    : map_(std::move(map)),
      margin_columns_(int(std::ceil(margin / map_.step_east))),
      margin_rows_(int(std::ceil(margin / map_.step_north))) {}

double Terrain::grid_height(int column, int row) const {
    const auto outside = [](int index, int count) { return std::max({0, -index, index - (count - 1)}); };
    const double beyond =
        std::hypot(outside(column, map_.columns) * map_.step_east, outside(row, map_.rows) * map_.step_north);
    const std::size_t index = std::size_t(mirrored(row, map_.rows)) * std::size_t(map_.columns) +
                              std::size_t(mirrored(column, map_.columns));
    return double(map_.heights[index]) * (1 - smooth(beyond / margin));
}

double Terrain::height(double east, double north) const {
    const double x = east / map_.step_east + (map_.columns - 1) / 2.0;
    const double y = (map_.rows - 1) / 2.0 - north / map_.step_north;
    if (x < -margin_columns_ || x > map_.columns - 1 + margin_columns_ || y < -margin_rows_ ||
        y > map_.rows - 1 + margin_rows_) {
        return 0;
    }
    const int column = int(std::floor(x));
    const int row = int(std::floor(y));
    const double fx = x - column;
    const double fy = y - row;
    const double upper = grid_height(column, row) * (1 - fx) + grid_height(column + 1, row) * fx;
    const double lower = grid_height(column, row + 1) * (1 - fx) + grid_height(column + 1, row + 1) * fx;
    return upper * (1 - fy) + lower * fy;
}

double Terrain::radius() const {
    const double heights =
        10e3;  // no mountain is higher, nor lies the edge of the map that far below its centre
    return heights + std::hypot(map_.columns / 2.0 * map_.step_east + margin,
                                map_.rows / 2.0 * map_.step_north + margin);
}

TerrainMesh Terrain::mesh(double ground_radius, const glm::dvec3& camera_position) const {
    const int columns = map_.columns + 2 * margin_columns_;
    const int rows = map_.rows + 2 * margin_rows_;
    TerrainMesh mesh;
    mesh.vertices.reserve(std::size_t(columns) * std::size_t(rows));
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int column = i - margin_columns_;
            const int row = j - margin_rows_;
            const double east = (column - (map_.columns - 1) / 2.0) * map_.step_east;
            const double north = ((map_.rows - 1) / 2.0 - row) * map_.step_north;
            const bool skirt = i == 0 || j == 0 || i == columns - 1 || j == rows - 1;
            const double height = grid_height(column, row);
            const double altitude = skirt ? -skirt_depth : height;
            const Place place = place_on_sphere(ground_radius, east, north, altitude);

            const double slope_east =
                (grid_height(column + 1, row) - grid_height(column - 1, row)) / (2 * map_.step_east);
            const double slope_north =
                (grid_height(column, row - 1) - grid_height(column, row + 1)) / (2 * map_.step_north);
            const glm::dvec3 normal =
                glm::normalize(place.up - slope_east * place.east - slope_north * place.north);
            mesh.vertices.push_back(
                TerrainVertex{glm::vec3(place.position - camera_position), glm::vec3(normal), float(height)});
        }
    }
    mesh.indices.reserve(6 * std::size_t(columns - 1) * std::size_t(rows - 1));
    for (int j = 0; j + 1 < rows; ++j) {
        for (int i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = std::uint32_t(j * columns + i);
            const std::uint32_t b = a + std::uint32_t(columns);
            for (const std::uint32_t index : {a, b, a + 1, a + 1, b, b + 1}) {
                mesh.indices.push_back(index);
            }
        }
    }
    return mesh;
}

}  // namespace deferred
