#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/constants.hpp>
#include <airlight/ray_sphere.hpp>
#include <airlight/view_path.hpp>
#include <airlight/viewpoint.hpp>

#include "converted.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "ulp.hpp"

// The whole way from an engine's position to a point in the air, in float against double. Both get the same
// float inputs, which double holds exactly, so every difference is the float formulas' own.

using namespace airlight_test;
using namespace airlight;

namespace {

constexpr double u = 0x1p-24;  // unit roundoff of float

// Rays whose decision changes when the inputs move by this many roundoffs of themselves are not counted.
constexpr double moved = 4;

/// An eye and where it looks, as an engine has them: floats.
struct Look {
    vec3<float> origin_up;  ///< of the point on the ground that `from_surface` counts from
    vec3<float> position;   ///< from the centre, or from that point
    bool from_surface;
    vec3<float> direction;
};

template <typename T>
Viewpoint<T> viewpoint(const Look& look) {
    const T radius = T(earth<float>().ground_radius);
    return look.from_surface ? viewpoint_from_surface(radius, vec3<T>(look.position), vec3<T>(look.origin_up))
                             : viewpoint_from_centre(radius, vec3<T>(look.position));
}

/// The float planet in T, so that both see the same numbers.
template <typename T>
Atmosphere<T> planet() {
    return converted<T>(earth<float>());
}

/// A unit vector at right angles to `up`.
vec3<double> sideways(Random& random, const vec3<double>& up) {
    vec3<double> side = glm::cross(up, random.direction<double>());
    return side / std::sqrt(glm::dot(side, side));
}

/// An eye `altitude` above the ground; up to 1000 km high it is counted from a point on the ground up to
/// 100 km away, which is how a float engine must do it, and from the planet's centre above that.
Look look_from(Random& random, double altitude) {
    const double radius = planet<double>().ground_radius;
    Look look{};
    look.from_surface = altitude < 1e6;
    look.origin_up = random.direction<float>();
    const vec3<double> up(look.origin_up);
    if (look.from_surface) {
        const double away = random.log_uniform(0.1, 1e5);
        const double curved = away * away / (2 * radius);  // the ground falls away from the tangent plane
        look.position = vec3<float>(up * (altitude - curved) + sideways(random, up) * away);
    } else {
        look.position = vec3<float>(up * (radius + altitude));
    }
    return look;
}

/// Turns the look so that the ray's closest approach to the centre is about `perigee`, on its way down. An
/// eye below that looks down a little.
void aim(Random& random, Look& look, double perigee) {
    const Viewpoint<double> eye = viewpoint<double>(look);
    const double r = planet<double>().ground_radius + eye.altitude;
    const double sine = perigee < r ? perigee / r : 1 - random.log_uniform(1e-12, 1e-2);
    const double cosine = std::sqrt((1 - sine) * (1 + sine));
    look.direction = vec3<float>(sideways(random, eye.up) * sine - eye.up * cosine);
}

struct Count {
    long decided = 0;
    long wrong = 0;
};

}  // namespace

TEST_SUITE_BEGIN("view_path_precision");

TEST_CASE("from position to decision, float decides as double for eyes from 1 m to 1e8 m") {
    Random random(90);
    const double radius = planet<double>().ground_radius;
    const double top = planet<double>().top_altitude;
    Count air;
    Count ground;
    for (int i = 0; i < 1000000; ++i) {
        Look look = look_from(random, random.log_uniform(1.0, 1e8));
        look.direction = random.direction<float>();
        if (i % 4 != 0) {  // three of four past an edge: the ground's, the air's top, or anywhere between
            const double edge =
                i % 4 == 1 ? radius : (i % 4 == 2 ? radius + top : radius + random.unit() * top);
            aim(random, look, edge + random.log_uniform(0.1, 1e6) * (random.below(2) == 0 ? 1 : -1));
        }
        const Viewpoint<double> eye = viewpoint<double>(look);
        const vec3<double> direction(look.direction);
        const vec3<double> across = glm::cross(eye.up, direction);
        const double sine = std::sqrt(glm::dot(across, across));
        const double mu = glm::dot(eye.up, direction);
        const double height = std::fmax(eye.altitude, 0.0);
        // Depth of the closest approach below the ground, in the form that a direction a roundoff too long or
        // too short does not move by a roundoff of the radius.
        const double depth = radius * mu * mu / (1 + sine) - height * sine;
        const double size = std::sqrt(glm::dot(look.position, look.position));
        // What moves the closest approach: the direction and the vertical turn by a roundoff each (times the
        // way to the closest approach), the position moves by a roundoff of its size, the radius by one of
        // its share.
        const double reach = moved * u * ((radius + height) * std::fabs(mu) + size + radius * mu * mu);
        const ViewPath<float> in_float =
            view_path(planet<float>(), viewpoint<float>(look), look.direction, no_surface<float>());
        const ViewPath<double> in_double = view_path(planet<double>(), eye, direction, no_surface<double>());
        const bool level = std::fabs(mu) <= moved * u;  // up or down?
        const bool at_top = std::fabs(eye.altitude - top) <= moved * u * (size + top);
        if (!(level || at_top || (height > top && std::fabs(depth + top) <= reach))) {
            ++air.decided;
            air.wrong += in_float.in_air != in_double.in_air ? 1 : 0;
        }
        const bool at_ground = std::fabs(eye.altitude) <= moved * u * size;
        if (!(level || at_ground || std::fabs(depth) <= reach)) {
            ++ground.decided;
            ground.wrong += in_float.reaches_ground != in_double.reaches_ground ? 1 : 0;
        }
    }
    std::printf(
        "viewpoint and view_path, float against double: %ld of %ld wrong (air), %ld of %ld wrong (ground); a "
        "million rays, eyes from 1 m to 1e8 m\n",
        air.wrong, air.decided, ground.wrong, ground.decided);
    CHECK(air.decided > 950000);     // the rest is closer to an edge than four roundoffs of its inputs
    CHECK(ground.decided > 950000);  // likewise
    CHECK(air.wrong == 0);
    CHECK(ground.wrong == 0);
}

TEST_CASE("intersect_ray_sphere decides in float as in double, from 1 m to 1e8 m") {
    Random random(91);
    const float radius_in_float = earth<float>().ground_radius;
    const double radius = radius_in_float;
    Count hit;
    for (int i = 0; i < 1000000; ++i) {
        const float altitude = static_cast<float>(random.log_uniform(1.0, 1e8));
        float mu = static_cast<float>(random.uniform(-1.0, 1.0));
        const double r = radius + static_cast<double>(altitude);
        if (i % 2 == 0) {  // a closest approach within 100 km of the sphere
            const double perigee = radius + random.log_uniform(1e-3, 1e5) * (random.below(2) == 0 ? 1 : -1);
            const double sine = std::fmin(perigee / r, 1.0);
            mu = static_cast<float>(-std::sqrt((1 - sine) * (1 + sine)));
        }
        const double m = static_cast<double>(mu);
        const double sine = std::sqrt((1 - m) * (1 + m));
        // The gap between the sphere and the closest approach, and what moves it: radius, altitude and mu, by
        // their own roundoffs.
        const double gap = radius * m * m / (1 + sine) - static_cast<double>(altitude) * sine;
        const double reach = moved * u *
                             (radius * (m * m / (1 + sine)) + static_cast<double>(altitude) * sine +
                              r * m * m / std::fmax(sine, u));
        if (std::fabs(gap) <= reach) {
            continue;
        }
        ++hit.decided;
        hit.wrong += intersect_ray_sphere(radius_in_float, altitude, mu).hit !=
                             intersect_ray_sphere(radius, static_cast<double>(altitude), m).hit
                         ? 1
                         : 0;
    }
    std::printf("intersect_ray_sphere, float against double: %ld of %ld wrong\n", hit.wrong, hit.decided);
    CHECK(hit.decided > 700000);  // the rest is closer to the edge than four roundoffs of its inputs
    CHECK(hit.wrong == 0);
}

TEST_CASE("from position to altitude along the ray, float follows double up to 10 km") {
    Random random(92);
    double worst_altitude = 0;  // [m]
    double worst_near = 0;      // [m], up to 10 km along
    double worst_roundoffs = 0;
    long compared = 0;
    for (int i = 0; i < 400000; ++i) {
        Look look = look_from(random, random.log_uniform(1.0, 1e4));
        look.direction = random.direction<float>();
        if (i % 2 == 0) {  // near the horizon, where rays stay low for long
            aim(random, look, planet<double>().ground_radius + random.uniform(-2e3, 1e4));
        }
        const Viewpoint<float> eye_in_float = viewpoint<float>(look);
        const Viewpoint<double> eye = viewpoint<double>(look);
        const AirRay<float> in_float =
            air_ray(planet<float>(), eye_in_float, look.direction, no_surface<float>());
        const AirRay<double> in_double =
            air_ray(planet<double>(), eye, vec3<double>(look.direction), no_surface<double>());
        const float t = static_cast<float>(random.log_uniform(1.0, 4e5));
        const double got = static_cast<double>(
            altitude_along_ray(planet<float>().ground_radius, in_float.altitude, in_float.along, t));
        const double expected = altitude_along_ray(planet<double>().ground_radius, in_double.altitude,
                                                   in_double.along, static_cast<double>(t));
        if (expected < 0 || expected > 1e4) {
            continue;
        }
        ++compared;
        const double error = std::fabs(got - expected);
        const double size = std::sqrt(glm::dot(look.position, look.position));
        // The vertical and the direction turn by a roundoff each, over the distance; the position moves by
        // one.
        const double condition = static_cast<double>(t) + size + eye.altitude;
        worst_altitude = std::fmax(worst_altitude, error);
        worst_near = t <= 1e4F ? std::fmax(worst_near, error) : worst_near;
        worst_roundoffs = std::fmax(worst_roundoffs, error / (u * condition));
    }
    std::printf(
        "viewpoint, air_ray and altitude_along_ray, float against double: altitude up to 10 km within %.2g m "
        "up to 10 km along, %.2g m up to 400 km along, %.2g roundoffs of the way; %ld rays\n",
        worst_near, worst_altitude, worst_roundoffs, compared);
    CHECK(compared > 100000);
    CHECK(worst_near <= 0.01);      // the accuracy that the design asks for
    CHECK(worst_roundoffs <= 8.0);  // some ten operations, two of them on the vertical
}

TEST_SUITE_END();
