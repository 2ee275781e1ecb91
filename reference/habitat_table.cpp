#include "habitat_table.hpp"

#include <airlight/habitat_indirect.hpp>
#include <cmath>
#include <sstream>

#include "support/files.hpp"
#include "support/rows.hpp"

namespace reference {
namespace {

using airlight::pi;

/// Places and directions by chance, always the same.
class Chooser {
  public:
    explicit Chooser(const Habitat& habitat) : habitat_(habitat) {}

    double between(double low, double high) {
        return low + (high - low) * random_();
    }
    /// At this distance from the axis.
    Vector at_radius(double radius) {
        const double angle = 2 * pi<double> * random_();
        const double x = habitat_.lights.half_length * between(-0.99, 0.99);
        return Vector(x, radius * std::cos(angle), radius * std::sin(angle));
    }
    Vector anywhere() {
        return at_radius(0.999 * habitat_.air.radius * std::sqrt(random_()));
    }
    /// Over the ground, as often between 2 m and 14 m as between 14 m and 100 m.
    Vector over_ground() {
        return at_radius(habitat_.air.radius - 2 * std::pow(50.0, random_()));
    }
    Vector direction() {
        return turned(Vector(1, 0, 0), 2 * random_() - 1, random_);
    }
    airlight::LinearLight<double> strip() {
        return airlight::habitat_strip(habitat_.air, habitat_.lights, static_cast<int>(6 * random_()));
    }
    static Vector on(const airlight::LinearLight<double>& strip, double along) {
        return strip.centre + along * strip.half_length * strip.along;
    }
    /// From a fifth of a width to four widths off a strip, on the side where the habitat is.
    Vector near_strip() {
        const airlight::LinearLight<double> light = strip();
        const Vector side = glm::cross(light.normal, light.along);
        const double angle = between(0.15, pi<double> - 0.15);
        const double away = 0.2 * light.width * std::pow(20.0, random_());
        return on(light, between(-1, 1)) + away * (std::cos(angle) * side + std::sin(angle) * light.normal);
    }

  private:
    const Habitat& habitat_;
    Random random_{2026, 0};
};

struct Traced {
    Estimate once;
    Estimate evenly;
    Estimate all;
    Estimate straight;
    Estimate irradiance;
};

}  // namespace

std::vector<HabitatRay> judged_habitat_rays(const Habitat& habitat) {
    Chooser choose(habitat);
    std::vector<HabitatRay> rays;
    const auto add = [&](const char* kind, const Vector& eye, const Vector& direction) {
        const Vector unit = direction / glm::length(direction);
        const double distance = airlight::habitat_wall(habitat.air, habitat.lights, eye, unit).distance;
        rays.push_back(HabitatRay{kind, eye, unit, distance});
    };
    for (int i = 0; i < 16; ++i) {
        const Vector eye = choose.anywhere();
        add("anywhere", eye, choose.direction());
    }
    for (int i = 0; i < 16; ++i) {
        const Vector eye = choose.over_ground();
        add("over ground", eye, choose.direction());
    }
    for (int i = 0; i < 6; ++i) {
        const Vector eye(choose.between(-23e3, 23e3), 0, 0);
        add("on the axis", eye, i == 0 ? Vector(eye.x < 0 ? 1 : -1, 0, 0) : choose.direction());
    }
    for (int i = 0; i < 12; ++i) {
        const Vector eye = choose.near_strip();
        add("near a strip", eye, choose.direction());
    }
    for (int i = 0; i < 8; ++i) {
        const Vector eye = i < 4 ? choose.anywhere() : choose.over_ground();
        add("towards a strip", eye, Chooser::on(choose.strip(), choose.between(-1, 1)) - eye);
    }
    for (int i = 0; i < 6; ++i) {
        const Vector eye = choose.near_strip();
        add("along a strip", eye, Vector(i % 2 == 0 ? 1 : -1, 0, 0) + 0.01 * choose.direction());
    }
    return rays;
}

void write_habitat_table(const Habitat& habitat, std::uint64_t walks, std::uint64_t seed,
                         const std::filesystem::path& path) {
    support::make_writable_directory_of(path);
    const std::vector<HabitatRay> rays = judged_habitat_rays(habitat);
    Habitat even = habitat;
    even.isotropic = true;
    std::vector<Traced> traced(3 * rays.size());
    const support::Rows jobs("tracing a habitat");
    jobs(static_cast<int>(traced.size()), [&](int job) {
        const auto i = static_cast<std::size_t>(job);
        const HabitatRay& ray = rays[i / 3];
        const int channel = job % 3;
        const std::uint64_t own = seed + 1000003 * i;  // or all would be off the same way
        const auto air = [&](const Habitat& medium, int orders, std::uint64_t count) {
            return habitat_air_light(medium, channel, ray.eye, ray.direction, ray.distance, orders, count,
                                     own);
        };
        const Vector end = ray.eye + ray.distance * ray.direction;
        const Vector normal = airlight::habitat_normal(habitat.air, habitat.lights, end);
        const auto wall = [&](int bounces, std::uint64_t count) {
            return habitat_surface_irradiance(habitat, channel, end, normal, bounces, count, own);
        };
        traced[i] = Traced{air(habitat, 1, 2 * walks), air(even, 1, 2 * walks),
                           air(habitat, every_order, walks), wall(0, 2 * walks), wall(every_order, walks)};
    });

    std::ostringstream out;
    out.precision(9);
    out << "# Light in the habitat of rama_air and rama_lights, walls of albedo " << habitat.albedo.x << " "
        << habitat.albedo.y << " " << habitat.albedo.z
        << ", per unit of the strips' radiance: what the\n"
           "# air of a ray adds, scattered once, once and evenly to all sides, and with all orders; and the "
           "irradiance of the wall where the\n"
        << "# ray ends, straight from the strips and with all orders. Written by trace_habitat --table: "
        << walks << " walks for all orders, " << 2 * walks << " for the rest,\n"
        << "# seed " << seed << ". Lengths in metres.\n"
        << "kind,x,y,z,dx,dy,dz,distance,channel,once,once_error,evenly,evenly_error,all,all_error,straight,"
           "straight_error,irradiance,irradiance_error\n";
    for (std::size_t i = 0; i < traced.size(); ++i) {
        const HabitatRay& ray = rays[i / 3];
        out << ray.kind;
        for (const Vector& v : {ray.eye, ray.direction}) {
            out << "," << v.x << "," << v.y << "," << v.z;
        }
        out << "," << ray.distance << "," << i % 3;
        const Traced& t = traced[i];
        for (const Estimate& e : {t.once, t.evenly, t.all, t.straight, t.irradiance}) {
            out << "," << e.mean << "," << e.error;
        }
        out << "\n";
    }
    support::write_file(path, out.str());
}

}  // namespace reference
