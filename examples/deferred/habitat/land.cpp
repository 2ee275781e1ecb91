#include "habitat/land.hpp"

#include <airlight/constants.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "support/error.hpp"

namespace deferred::habitat {
namespace {

constexpr int steps_around = 560;  // of the mesh, and along as fine as that
constexpr int cap_rings = 48;
constexpr double flat_widths = 2.5;     // of a strip, to each side of its middle, without relief
constexpr double foothill_widths = 20;  // further out the hills have their whole height
constexpr double flat_part = 0.02;      // at least this part of the radius

/// There and back again: 0 to 1 to 0 while `x` goes from 0 to 2.
double mirrored(double x) {
    const double phase = x - 2 * std::floor(x / 2);
    return phase < 1 ? phase : 2 - phase;
}

double smooth(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double sampled(const HeightMap& map, double x, double y) {
    const int column = std::clamp(int(x), 0, map.columns - 2);
    const int row = std::clamp(int(y), 0, map.rows - 2);
    const double fx = x - column;
    const double fy = y - row;
    const auto at = [&](int c, int r) {
        return double(map.heights[std::size_t(r) * std::size_t(map.columns) + std::size_t(c)]);
    };
    const double upper = at(column, row) * (1 - fx) + at(column + 1, row) * fx;
    const double lower = at(column, row + 1) * (1 - fx) + at(column + 1, row + 1) * fx;
    return upper * (1 - fy) + lower * fy;
}

glm::dvec3 place(double radius, double along, double around, double height) {
    return {along, (radius - height) * std::cos(around), (radius - height) * std::sin(around)};
}

}  // namespace

Land::Land(HeightMap map, double radius, const airlight::HabitatLights<float>& lights, bool plain)
    : map_(std::move(map)), plain_(plain), radius_(radius), lights_(lights) {
    const auto [low, high] = std::minmax_element(map_.heights.begin(), map_.heights.end());
    lowest_ = double(*low);
    if (!plain && double(*high) - lowest_ > 0.5 * radius) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "the land is %.0f m high, more than half of the cylinder's radius of %.0f m; give a "
                      "larger --radius or --land plain",
                      double(*high) - lowest_, radius);
        throw support::Error(text);
    }
}

double Land::height(double along, double around) const {
    if (plain_) {
        return 0;
    }
    // The map lies once there and once back around the cylinder, whatever the radius.
    const double pi = airlight::pi<double>;
    const double x = mirrored(around / pi) * (map_.columns - 1);
    const double extent = map_.step_north * (map_.rows - 1);
    const double y = mirrored(along / extent) * (map_.rows - 1);
    const double third = 2 * pi / 3;
    const double from_strip = std::abs(around - third * std::round(around / third)) * radius_;
    const double before =
        std::max({double(lights_.begin) - std::abs(along), std::abs(along) - double(lights_.end), 0.0});
    const double flat = std::max(flat_widths * double(lights_.width), flat_part * radius_);
    const double foothills = std::max(foothill_widths * double(lights_.width), 4 * flat);
    const double hills = smooth((std::hypot(from_strip, before) - flat) / (foothills - flat));
    return hills * (sampled(map_, x, y) - lowest_);
}

LandMesh Land::mesh() const {
    const double pi = airlight::pi<double>;
    const double half_length = double(lights_.half_length);
    const int steps_along =
        std::clamp(int(std::ceil(half_length * steps_around / (pi * radius_))), 2, 4 * steps_around);
    const double step_around = 2 * pi / steps_around;
    const double step_along = 2 * half_length / steps_along;
    const auto at = [&](double along, double around) {
        return place(radius_, along, around, height(along, around));
    };
    LandMesh mesh;
    const auto grid = [&](int rows, auto vertex) {
        const std::uint32_t first = std::uint32_t(mesh.vertices.size());
        for (int j = 0; j <= rows; ++j) {
            for (int i = 0; i <= steps_around; ++i) {
                mesh.vertices.push_back(vertex(j, i * step_around));
            }
        }
        const std::uint32_t columns = std::uint32_t(steps_around + 1);
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < steps_around; ++i) {
                const std::uint32_t a = first + std::uint32_t(j) * columns + std::uint32_t(i);
                const std::uint32_t b = a + columns;
                mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
            }
        }
    };
    grid(steps_along, [&](int j, double around) {
        const double along = j * step_along - half_length;
        const glm::dvec3 forward =
            at(along + 0.5 * step_along, around) - at(along - 0.5 * step_along, around);
        const glm::dvec3 turned =
            at(along, around + 0.5 * step_around) - at(along, around - 0.5 * step_around);
        return LandVertex{glm::vec3(at(along, around)),
                          glm::vec3(glm::normalize(glm::cross(forward, turned))),
                          float(height(along, around))};
    });
    for (const double side : {-1.0, 1.0}) {
        grid(cap_rings, [&](int j, double around) {
            return LandVertex{glm::vec3(place(radius_, side * half_length, around, radius_ * j / cap_rings)),
                              glm::vec3(-side, 0, 0), 0};
        });
    }
    return mesh;
}

}  // namespace deferred::habitat
