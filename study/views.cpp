#include "views.hpp"

#include <cmath>
#include <limits>
#include <samplers.hpp>
#include <sstream>

namespace study {
namespace {

using airlight::vec3;

constexpr double no_surface = std::numeric_limits<double>::infinity();
constexpr double space_altitude = 1000e3;

double radians(double degrees) {
    return degrees * airlight::pi<double> / 180.0;
}

vec3<double> direction(double elevation, double azimuth) {
    const double e = radians(elevation);
    const double a = radians(azimuth);
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

airlight::Viewpoint<double> eye_at(double altitude) {
    return {altitude, vec3<double>(0.0, 0.0, 1.0)};
}

/// From `altitude` downwards so that the ray's closest approach is at `perigee`.
vec3<double> past(const World& world, double altitude, double perigee) {
    const double radius = world.air.ground_radius;
    const double sine = (radius + perigee) / (radius + altitude);
    return {sine, 0.0, -std::sqrt((1.0 - sine) * (1.0 + sine))};
}

template <typename... Parts>
std::string text(const Parts&... parts) {
    std::ostringstream out;
    (out << ... << parts);
    return out.str();
}

void add_ground(std::size_t world, std::vector<View>& out) {
    for (const double altitude : {2.0, 200.0}) {
        for (const double sun : {90.0, 45.0, 10.0, 2.0, 0.0, -3.0, -6.0}) {
            for (const double elevation : {90.0, 20.0, 1.0, 0.1}) {
                for (const double azimuth : {0.0, 120.0}) {
                    if (altitude > 2.0 && azimuth > 0.0) {
                        continue;
                    }
                    out.push_back(
                        {"ground",
                         text(altitude, " m; sun ", sun, "; view ", elevation, " / ", azimuth),
                         world,
                         {eye_at(altitude), direction(elevation, azimuth), direction(sun, 0.0), no_surface}});
                }
            }
        }
    }
}

void add_high(std::size_t world, std::vector<View>& out) {
    for (const double sun : {45.0, 5.0, -3.0}) {
        for (const double elevation : {30.0, 0.0, -2.0, -10.0, -60.0}) {
            out.push_back({"high",
                           text("10 km; sun ", sun, "; view ", elevation),
                           world,
                           {eye_at(10e3), direction(elevation, 30.0), direction(sun, 0.0), no_surface}});
        }
    }
}

void add_space(std::size_t world, std::vector<View>& out) {
    for (const double sun : {60.0, 0.0, -20.0, -60.0}) {
        for (const double perigee : {-1000e3, -10e3, 5e3, 20e3, 50e3}) {
            out.push_back({"space",
                           text("space; sun ", sun, "; perigee ", perigee / 1e3, " km"),
                           world,
                           {eye_at(space_altitude), past(worlds()[world], space_altitude, perigee),
                            direction(sun, 40.0), no_surface}});
        }
    }
}

void add_surfaces(std::size_t world, std::vector<View>& out) {
    for (const double sun : {60.0, 5.0}) {
        for (const double distance : {1e3, 10e3, 100e3}) {
            out.push_back({"surface",
                           text("200 m; sun ", sun, "; surface at ", distance / 1e3, " km"),
                           world,
                           {eye_at(200.0), direction(-0.1, 50.0), direction(sun, 0.0), distance}});
        }
    }
}

/// A sun at an elevation over the place that a ray is about: where it meets the ground, or comes closest.
vec3<double> sun_over(const World& world, double altitude, const vec3<double>& towards, double elevation,
                      airlight_test::Random& random) {
    const double radius = world.air.ground_radius;
    const vec3<double> eye(0.0, 0.0, radius + altitude);
    const double along = glm::dot(eye, towards);
    const double chord = along * along - glm::dot(eye, eye) + radius * radius;
    const double way = std::max(-along - (chord > 0.0 ? std::sqrt(chord) : 0.0), 0.0);
    const vec3<double> up = glm::normalize(eye + way * towards);
    const vec3<double> level = glm::normalize(glm::cross(up, random.direction<double>()));
    return std::sin(radians(elevation)) * up + std::cos(radians(elevation)) * level;
}

/// Half of the eyes stand below 1 km, a quarter up to the air's top, a quarter in space; there they look
/// at the disc and the limb. Suns from the zenith to 10 degrees below the horizon, most of them low; a
/// quarter of the rays in the air ends on a surface.
View random_view(airlight_test::Random& random, std::size_t world, int number) {
    const airlight::Atmosphere<double>& air = worlds()[world].air;
    const int where = random.below(4);
    const double altitude = where < 2    ? random.log_uniform(1.0, 1e3)
                            : where == 2 ? random.log_uniform(1e3, air.top_altitude)
                                         : random.log_uniform(2.0 * air.top_altitude, 1e7);
    const double azimuth = random.uniform(0.0, 360.0);
    vec3<double> towards;
    if (where == 3) {
        const bool limb = random.below(2) == 0;
        const double perigee =
            limb ? random.uniform(-20e3, air.top_altitude) : -random.uniform(0.0, air.ground_radius);
        const vec3<double> in_plane = past(worlds()[world], altitude, perigee);
        towards = in_plane.x * direction(0.0, azimuth) + vec3<double>(0.0, 0.0, in_plane.z);
    } else {
        const bool level = random.below(2) == 0;
        towards = direction(level ? random.uniform(-3.0, 10.0) : random.uniform(-20.0, 90.0), azimuth);
    }
    const double sun = random.uniform(-10.0, random.below(2) == 0 ? 90.0 : 10.0);
    const bool ends = where < 3 && random.below(4) == 0;
    return {"random",
            text("random ", number),
            world,
            {eye_at(altitude), towards, sun_over(worlds()[world], altitude, towards, sun, random),
             ends ? random.log_uniform(100.0, 300e3) : no_surface}};
}

}  // namespace

std::vector<View> suite() {
    std::vector<View> out;
    for (std::size_t world = 0; world < worlds().size(); ++world) {
        add_ground(world, out);
        add_high(world, out);
        add_space(world, out);
        add_surfaces(world, out);
    }
    return out;
}

std::vector<View> random_views(int count) {
    airlight_test::Random random(20260101);
    std::vector<View> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(random_view(random, static_cast<std::size_t>(i) % worlds().size(), i));
    }
    return out;
}

View noon_zenith(std::size_t world) {
    return {"reference",
            "zenith at noon",
            world,
            {eye_at(2.0), vec3<double>(0.0, 0.0, 1.0), vec3<double>(0.0, 0.0, 1.0), no_surface}};
}

}  // namespace study
