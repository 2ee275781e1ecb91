#include "objects.hpp"

#include <cmath>
#include <utility>

#include <airlight/constants.hpp>

namespace deferred {
namespace {

constexpr double degree = airlight::pi<double> / 180;
constexpr double farthest = 150e3;  // [m] from there on none of them is as wide as 1/300

/// Where something stands: its foot or middle, and its own directions.
struct Stand {
    glm::dvec3 origin;  ///< [m] from the landscape's centre at altitude 0
    glm::dvec3 right;
    glm::dvec3 forward;
    glm::dvec3 up;

    glm::dvec3 at(const glm::dvec3& own) const {
        return origin + own.x * right + own.y * forward + own.z * up;
    }
    glm::dvec3 turned(const glm::dvec3& own) const {
        return own.x * right + own.y * forward + own.z * up;
    }
};

Stand stand(const Place& place, double heading) {
    const double s = std::sin(heading * degree);
    const double c = std::cos(heading * degree);
    return Stand{place.position, c * place.east - s * place.north, s * place.east + c * place.north,
                 place.up};
}

/// What a face is made of.
struct Paint {
    glm::vec3 albedo;
    float roughness;
};

const Paint concrete{{0.32f, 0.30f, 0.27f}, 1};
const Paint sandstone{{0.42f, 0.32f, 0.22f}, 1};
const Paint white{{0.75f, 0.75f, 0.74f}, 1};
const Paint gold{{0.55f, 0.38f, 0.14f}, 0.6f};
const Paint panel{{0.03f, 0.04f, 0.11f}, 0.5f};

class Builder {
  public:
    explicit Builder(const glm::dvec3& camera_position) : camera_(camera_position) {}

    bool seen(const glm::dvec3& place) const {
        return glm::distance(place, camera_) < farthest;
    }

    /// A box from one corner to the opposite one.
    void box(const Stand& stand, const glm::dvec3& low, const glm::dvec3& high, const Paint& paint) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 2; ++side) {
                glm::dvec3 normal(0);
                normal[axis] = side == 0 ? -1 : 1;
                const int u = (axis + 1) % 3;
                const int v = (axis + 2) % 3;
                const std::uint32_t first = std::uint32_t(mesh.vertices.size());
                for (int corner = 0; corner < 4; ++corner) {
                    glm::dvec3 own = side == 0 ? low : high;
                    own[u] = (corner & 1) != 0 ? high[u] : low[u];
                    own[v] = (corner & 2) != 0 ? high[v] : low[v];
                    add(stand.at(own), stand.turned(normal), paint);
                }
                quad(first, first + 1, first + 2, first + 3);
            }
        }
    }

    void ball(const glm::dvec3& middle, double radius, const Paint& paint) {
        constexpr int rings = 48;
        constexpr int around = 96;
        const std::uint32_t first = std::uint32_t(mesh.vertices.size());
        for (int i = 0; i <= rings; ++i) {
            for (int j = 0; j <= around; ++j) {
                const double theta = i * airlight::pi<double> / rings;
                const double phi = 2 * j * airlight::pi<double> / around;
                const glm::dvec3 normal(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                        std::cos(theta));
                add(middle + radius * normal, normal, paint);
            }
        }
        grid(first, rings, around + 1);
    }

    /// Half a ring of square section that stands upright across `forward`, bent around the stand's origin.
    void arch(const Stand& stand, double inner, double outer, double half_depth, const Paint& paint) {
        constexpr int pieces = 48;
        // Its four sides: where their edges lie, and whether they look outwards, inwards, ahead or back.
        const double radii[4][2] = {{outer, outer}, {inner, inner}, {inner, outer}, {inner, outer}};
        const double depths[4][2] = {{-1, 1}, {-1, 1}, {1, 1}, {-1, -1}};
        const glm::dvec2 looks[4] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        for (int side = 0; side < 4; ++side) {
            const std::uint32_t first = std::uint32_t(mesh.vertices.size());
            for (int i = 0; i <= pieces; ++i) {
                const double angle = i * airlight::pi<double> / pieces;
                const glm::dvec3 out(std::cos(angle), 0, std::sin(angle));
                for (int edge = 0; edge < 2; ++edge) {
                    const glm::dvec3 own =
                        radii[side][edge] * out + glm::dvec3(0, half_depth * depths[side][edge], 0);
                    const glm::dvec3 normal = looks[side].x * out + glm::dvec3(0, looks[side].y, 0);
                    add(stand.at(own), stand.turned(normal), paint);
                }
            }
            grid(first, pieces, 2);
        }
    }

    ObjectMesh mesh;

  private:
    void add(const glm::dvec3& position, const glm::dvec3& normal, const Paint& paint) {
        mesh.vertices.push_back(
            ObjectVertex{glm::vec3(position - camera_), glm::vec3(normal), paint.albedo, paint.roughness});
    }

    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        for (const std::uint32_t index : {a, b, c, c, b, d}) {
            mesh.indices.push_back(index);
        }
    }

    void grid(std::uint32_t first, int rows, int columns) {
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j + 1 < columns; ++j) {
                const std::uint32_t a = first + std::uint32_t(i * columns + j);
                quad(a, a + 1, a + std::uint32_t(columns), a + std::uint32_t(columns) + 1);
            }
        }
    }

    glm::dvec3 camera_;
};

void add_valley(Builder& builder, const Terrain& terrain, double ground_radius) {
    // Across the valley of the fault, so that a low sun in the west-south-west stands behind them.
    constexpr double heading = 250;
    const double s = std::sin(heading * degree);
    const double c = std::cos(heading * degree);
    const auto on_ground = [&](double ahead, double aside) {
        const double east = 1492 + ahead * s + aside * c;
        const double north = 1071 + ahead * c - aside * s;
        return stand(place_on_sphere(ground_radius, east, north, terrain.height(east, north)), heading);
    };
    constexpr double foot = -120;  // [m] into the slope
    for (int i = 0; i < 6; ++i) {
        const Stand slab = on_ground(3000 + 60 * i, 190.0 * i - 475);
        if (builder.seen(slab.origin)) {
            builder.box(slab, glm::dvec3(-62, -20, foot), glm::dvec3(62, 20, 420), concrete);
        }
    }
    Stand arch = on_ground(2200, -750);
    if (builder.seen(arch.origin)) {
        for (const double side : {-1.0, 1.0}) {
            builder.box(arch, glm::dvec3(side * 160 - 30, -30, foot), glm::dvec3(side * 160 + 30, 30, 150),
                        sandstone);
        }
        arch.origin += 150.0 * arch.up;
        builder.arch(arch, 130, 190, 30, sandstone);
    }
}

void add_orbit(Builder& builder, double ground_radius) {
    // Around the camera `orbit`: both 3 km from it, one below the horizon, the other above.
    constexpr double heading = 250;
    const Place camera = place_on_sphere(ground_radius, 560e3, 230e3, 400e3);
    const auto ahead = [&](double aside, double pitch, double distance) {
        Stand s = stand(camera, heading + aside);
        s.origin += distance * (std::cos(pitch * degree) * s.forward + std::sin(pitch * degree) * s.up);
        return s;
    };
    Stand station = ahead(-12, -31, 3000);
    if (!builder.seen(station.origin)) {
        return;
    }
    builder.box(station, glm::dvec3(-60, -250, -60), glm::dvec3(60, 250, 60), white);
    builder.box(station, glm::dvec3(-60, -100, 60), glm::dvec3(60, 40, 110), gold);
    builder.box(station, glm::dvec3(-520, -10, -10), glm::dvec3(520, 10, 10), concrete);
    for (const double side : {-1.0, 1.0}) {
        for (const double along : {-1.0, 1.0}) {
            const double x = side * 330;
            const double y = along * 150;
            builder.box(station, glm::dvec3(x - 170, y - 120, -4), glm::dvec3(x + 170, y + 120, 4), panel);
        }
    }
    builder.ball(ahead(14, -8, 3000).origin, 200, white);
}

}  // namespace

ObjectMesh object_mesh(const Terrain& terrain, double ground_radius, const glm::dvec3& camera_position) {
    Builder builder(camera_position);
    add_valley(builder, terrain, ground_radius);
    add_orbit(builder, ground_radius);
    return std::move(builder.mesh);
}

}  // namespace deferred
