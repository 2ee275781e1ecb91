#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/constants.hpp>
#include <airlight/view_path.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// A planet of which only the two spheres matter here.
template <typename T>
Atmosphere<T> shell(T ground_radius, T top_altitude) {
    Atmosphere<T> atmosphere = earth<T>();
    atmosphere.ground_radius = ground_radius;
    atmosphere.top_altitude = top_altitude;
    return atmosphere;
}

template <typename T>
vec3<T> down() {
    return vec3<T>(T(0), T(0), T(-1));
}

template <typename T>
vec3<T> up() {
    return vec3<T>(T(0), T(0), T(1));
}

template <typename T>
Viewpoint<T> eye_at(T altitude) {
    return Viewpoint<T>{altitude, up<T>()};
}

// Distances along a vertical ray round to a few ulp of themselves.
template <typename T>
void check_path(const char* which, const ViewPath<T>& path, long double begin, long double end, bool ground) {
    CAPTURE(std::string(which));
    CHECK(path.in_air);
    CHECK(path.reaches_ground == ground);
    CHECK_WITHIN(compare_ulp("view_path.begin", {}, path.begin, begin), 4.0L);
    CHECK_WITHIN(compare_ulp("view_path.end", {}, path.end, end), 4.0L);
}

template <typename T>
void check_no_air(const ViewPath<T>& path) {
    CHECK_FALSE(path.in_air);
    CHECK(path.begin == T(0));  // as the struct promises
    CHECK(path.end == T(0));
}

}  // namespace

TEST_SUITE_BEGIN("view_path");

// The cases of camera and target. Radius 6400 km, air up to 100 km, all vertical: worked out by hand.

TEST_CASE_TEMPLATE("camera inside, no surface: from the eye to the end of the air", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("up", view_path(planet, eye_at(T(20)), up<T>(), no_surface<T>()), 0, 80, false);
    check_path("down", view_path(planet, eye_at(T(20)), down<T>(), no_surface<T>()), 0, 20, true);
}

TEST_CASE_TEMPLATE("camera inside, surface inside: from the eye to the surface", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("up", view_path(planet, eye_at(T(20)), up<T>(), T(15)), 0, 15, false);
    check_path("down", view_path(planet, eye_at(T(20)), down<T>(), T(15)), 0, 15, false);
}

TEST_CASE_TEMPLATE("camera inside, surface outside the air: from the eye to the end of the air", T, float,
                   double, long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("up", view_path(planet, eye_at(T(20)), up<T>(), T(300)), 0, 80, false);
}

TEST_CASE_TEMPLATE("camera outside, surface inside: from the entry to the surface", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("down", view_path(planet, eye_at(T(300)), down<T>(), T(250)), 200, 250, false);
}

TEST_CASE_TEMPLATE("camera outside, no surface: from the entry to the ground", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("down", view_path(planet, eye_at(T(300)), down<T>(), no_surface<T>()), 200, 300, true);
}

TEST_CASE_TEMPLATE("camera outside, surface in front of the air: no air", T, float, double, long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    const ViewPath<T> path = view_path(planet, eye_at(T(300)), down<T>(), T(150));
    check_no_air(path);
    CHECK_FALSE(path.reaches_ground);
}

TEST_CASE_TEMPLATE("in_air says that the ray has air, wherever its two ends are", T, float, double,
                   long double) {
    // Our reading of a source whose flag in_atm is set when camera and point are both in space. From space to
    // space across the air, the ray has air; from space to space past it, none.
    const Atmosphere<T> planet = shell(T(6400), T(100));
    const T above = T(150);
    const T sine = (T(6400) + T(50)) / (T(6400) + above);  // closest approach at 50 km
    const vec3<T> across = vec3<T>(sine, T(0), -std::sqrt((T(1) - sine) * (T(1) + sine)));
    const ViewPath<T> through = view_path(planet, eye_at(above), across, T(5000));
    CHECK(through.in_air);
    CHECK(through.begin > T(0));
    CHECK(through.end < T(5000));
    CHECK_FALSE(view_path(planet, eye_at(above), -across, T(5000)).in_air);
}

TEST_CASE_TEMPLATE("a ray that misses the air, or leaves it behind, has no air", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    for (const vec3<T>& direction : {up<T>(), vec3<T>(T(1), T(0), T(0)), vec3<T>(T(0.8L), T(0), T(0.6L))}) {
        const ViewPath<T> path = view_path(planet, eye_at(T(300)), direction, no_surface<T>());
        check_no_air(path);
        CHECK_FALSE(path.reaches_ground);
    }
    // Aimed 200 km above the ground, past the air.
    const T sine = T(6600) / T(6400 + 12800);
    const vec3<T> past = vec3<T>(sine, T(0), -std::sqrt((T(1) - sine) * (T(1) + sine)));
    check_no_air(view_path(planet, eye_at(T(12800)), past, no_surface<T>()));
}

TEST_CASE_TEMPLATE("an eye below the ground counts as standing on it", T, float, double, long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    for (const T altitude : {T(-1e-3L), T(-1), T(-6400)}) {
        const ViewPath<T> sky = view_path(planet, eye_at(altitude), up<T>(), no_surface<T>());
        const ViewPath<T> standing = view_path(planet, eye_at(T(0)), up<T>(), no_surface<T>());
        CHECK(sky.in_air);
        CHECK(sky.begin == standing.begin);  // exact: the same altitude after clamping
        CHECK(sky.end == standing.end);
        check_no_air(view_path(planet, eye_at(altitude), down<T>(), no_surface<T>()));
    }
}

TEST_CASE_TEMPLATE("standing on the ground: the sky is all air, the ground none", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("up", view_path(planet, eye_at(T(0)), up<T>(), no_surface<T>()), 0, 100, false);
    const ViewPath<T> below = view_path(planet, eye_at(T(0)), down<T>(), no_surface<T>());
    check_no_air(below);
    CHECK(below.reaches_ground);  // after no distance at all
    // Level: to the top along the tangent, sqrt(100 (2 6400 + 100)) = 1135.78...
    const ViewPath<T> level = view_path(planet, eye_at(T(0)), vec3<T>(T(1), T(0), T(0)), no_surface<T>());
    check_path("level", level, 0, 1135.781669160054722178467596798471288L, false);
}

TEST_CASE_TEMPLATE("exactly on the top: down is all air, up is none, level is none", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("down", view_path(planet, eye_at(T(100)), down<T>(), no_surface<T>()), 0, 100, true);
    check_no_air(view_path(planet, eye_at(T(100)), up<T>(), no_surface<T>()));
    check_no_air(view_path(planet, eye_at(T(100)), vec3<T>(T(0), T(1), T(0)), no_surface<T>()));
}

TEST_CASE_TEMPLATE("a ray that touches the ground passes it by", T, float, double, long double) {
    const vec3<T> level = vec3<T>(T(0), T(-1), T(0));
    const ViewPath<T> path = view_path(shell(T(4), T(1)), eye_at(T(0)), level, no_surface<T>());
    CHECK(path.in_air);
    CHECK_FALSE(path.reaches_ground);
    CHECK(path.end == T(3));  // exact: the 3-4-5 triangle, sqrt(25 - 16)
}

TEST_CASE_TEMPLATE("no distance, no air; a speck of distance, a speck of air", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400e3L), T(100e3L));
    check_no_air(view_path(planet, eye_at(T(2)), up<T>(), T(0)));
    const ViewPath<T> speck = view_path(planet, eye_at(T(2)), vec3<T>(T(1), T(0), T(0)), T(1e-6L));
    CHECK(speck.in_air);
    CHECK(speck.end == T(1e-6L));  // exact: the minimum of three lengths
}

TEST_CASE_TEMPLATE(
    "the path ends where the surface is, ground or not, and a surface below the ground is never reached", T,
    float, double, long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    check_path("nearer than the ground", view_path(planet, eye_at(T(20)), down<T>(), T(19)), 0, 19, false);
    check_path("below the ground", view_path(planet, eye_at(T(20)), down<T>(), T(21)), 0, 20, true);
}

TEST_CASE_TEMPLATE("air_ray starts at the eye, or where the ray enters the air", T, float, double,
                   long double) {
    const Atmosphere<T> planet = shell(T(6400), T(100));
    const AirRay<T> inside = air_ray(planet, eye_at(T(20)), vec3<T>(T(0), T(0.8L), T(0.6L)), no_surface<T>());
    CHECK(inside.in_air);
    CHECK(inside.begin == T(0));
    CHECK(inside.altitude == T(20));
    CHECK_WITHIN(compare_ulp("air_ray.along", {}, inside.along, 6420 * 0.6L),
                 3.0L);  // 0.6, sum and product rounded
    const AirRay<T> outside = air_ray(planet, eye_at(T(300)), down<T>(), no_surface<T>());
    CHECK(outside.altitude == T(100));
    CHECK_WITHIN(compare_ulp("air_ray.begin", {}, outside.begin, 200.0L), 4.0L);
    CHECK_WITHIN(compare_ulp("air_ray.along", {}, outside.along, -6500.0L), 2.0L);
    CHECK_WITHIN(compare_ulp("air_ray.extent", {}, outside.extent, 100.0L), 4.0L);
}

TEST_CASE_TEMPLATE("altitude_along_ray: up by what is walked up, and 3-4-5 sideways", T, float, double,
                   long double) {
    // From radius 3 walk 4 sideways: distance 5 from the centre, altitude 2 above a sphere of 3.
    CHECK(altitude_along_ray(T(3), T(0), T(0), T(4)) == T(2));  // exact: integers
    CHECK(altitude_along_ray(T(3), T(1), T(4), T(2)) == T(3));  // exact: straight up
    CHECK(altitude_along_ray(T(3), T(1), T(-4), T(2)) == T(-1));
    CHECK(altitude_along_ray(T(3), T(1), T(-4), T(4)) == T(-3));  // the centre
}

TEST_CASE_TEMPLATE("a level ray is as high before the perigee as behind it", T, float, double, long double) {
    Random random(81);
    const T radius = T(6371000);
    for (int i = 0; i < 2000; ++i) {
        const T h = T(random.log_uniform(1, 1e5));
        const T t = T(random.log_uniform(1, 1e6));
        // Exact: from t before the perigee back to it and on by as much the terms only change sign.
        CHECK(altitude_along_ray(radius, h, T(0), t) == altitude_along_ray(radius, h, T(0), -t));
        // Walked to the other side of the perigee, the start's altitude is back: 3 roundoffs, the docstring's
        // bound.
        const T along = T(random.uniform(-1e6, 0));
        const long double condition =
            (static_cast<long double>(h) * (2.0L * radius + h) + 4.0L * along * along) / (2.0L * radius);
        CHECK_WITHIN(compare_roundoffs(
                         "altitude_along_ray",
                         {{"radius", radius}, {"altitude", h}, {"along", along}, {"distance", -2 * along}},
                         altitude_along_ray(radius, h, along, -2 * along), h, condition),
                     3.0L);
    }
}

TEST_CASE_TEMPLATE("paths scale exactly with the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two
    Random random(82);
    for (int i = 0; i < 20000; ++i) {
        const T radius = T(random.log_uniform(100.0, 7e7));
        const T top = radius * T(random.log_uniform(1e-3, 1.0));
        const T altitude = top * T(random.log_uniform(1e-4, 1e4));
        const T distance = random.below(3) == 0 ? no_surface<T>() : top * T(random.log_uniform(1e-3, 1e3));
        const vec3<T> direction = random.direction<T>();
        const ViewPath<T> a = view_path(shell(radius, top), eye_at(altitude), direction, distance);
        const ViewPath<T> b =
            view_path(shell(k * radius, k * top), eye_at(k * altitude), direction, k * distance);
        CHECK_UNARY(b.in_air == a.in_air);
        CHECK_UNARY(b.reaches_ground == a.reaches_ground);
        CHECK_UNARY(b.begin == k * a.begin);
        CHECK_UNARY(b.end == k * a.end);
    }
}

TEST_CASE_TEMPLATE("the frame does not matter: a planet turned by a quarter gives the same path", T, float,
                   double, long double) {
    Random random(83);
    const Atmosphere<T> planet = shell(T(6371000), T(100000));
    for (int i = 0; i < 5000; ++i) {
        const vec3<T> up_here = random.direction<T>();
        const vec3<T> d = random.direction<T>();
        const Viewpoint<T> eye = Viewpoint<T>{T(random.log_uniform(1, 1e7)), up_here};
        const Viewpoint<T> turned = Viewpoint<T>{eye.altitude, vec3<T>(-up_here.x, -up_here.y, up_here.z)};
        const ViewPath<T> a = view_path(planet, eye, d, no_surface<T>());
        const ViewPath<T> b = view_path(planet, turned, vec3<T>(-d.x, -d.y, d.z), no_surface<T>());
        // Exact: a half turn about z changes signs only, and squares and products of two signs lose them.
        CHECK_UNARY(a.in_air == b.in_air);
        CHECK_UNARY(a.begin == b.begin);
        CHECK_UNARY(a.end == b.end);
    }
}

TEST_CASE_TEMPLATE("paths agree with 50 digits", T, float, double, long double) {
    Worst begin;
    Worst end;
    for (const Row& row : reference("view_path")) {
        const T radius = row.input<T>("radius");
        const T top = row.input<T>("top");
        const T h = row.input<T>("h");
        const vec3<T> printed = vec3<T>(row.input<T>("dx"), T(0), row.input<T>("dz"));
        const vec3<T> direction = printed / std::sqrt(glm::dot(printed, printed));
        const T distance = row.text("distance") == "none" ? no_surface<T>() : row.input<T>("distance");
        const ViewPath<T> path = view_path(shell(radius, top), eye_at(h), direction, distance);
        CAPTURE(row.text("case"));
        CAPTURE(exact(radius));
        CAPTURE(exact(h));
        CAPTURE(exact(direction.x));
        CAPTURE(exact(direction.z));
        CHECK(path.in_air == (row.text("in_air") == "1"));
        CHECK(path.reaches_ground == (row.text("reaches_ground") == "1"));
        if (path.in_air) {
            begin.add(compare_roundoffs(
                "view_path.begin",
                {{"radius", radius}, {"top", top}, {"altitude", h}, {"dx", direction.x}, {"dz", direction.z}},
                path.begin, row.expected("begin"), row.expected("condition_begin")));
            end.add(compare_roundoffs(
                "view_path.end",
                {{"radius", radius}, {"top", top}, {"altitude", h}, {"dx", direction.x}, {"dz", direction.z}},
                path.end, row.expected("end"), row.expected("condition_end")));
        }
    }
    begin.print("against 50 digits");
    end.print("against 50 digits");
    // Some ten operations, and the direction is normalised in three, with most of it inside the condition.
    CHECK_WORST(begin, 4.0L);
    CHECK_WORST(end, 4.0L);
}

TEST_CASE("in float, 0 wrong decisions in a million rays from 1 m to 1e8 m") {
    // Against the textbook form in long double, for the very vectors that the function saw, normalised. Left
    // out are rays that the rounding of up, direction and altitude could flip: 3 roundoffs of each.
    Random random(84);
    const Atmosphere<float> planet = earth<float>();
    const long double R = planet.ground_radius;
    const long double top = planet.top_altitude;
    long decided = 0;
    long wrong_air = 0;
    long wrong_ground = 0;
    for (int i = 0; i < 1000000; ++i) {
        const float altitude = static_cast<float>(random.log_uniform(1.0, 1e8));
        const vec3<float> up_here = random.direction<float>();
        vec3<float> direction = random.direction<float>();
        if (i % 4 != 0) {
            // Aimed at the limb: from deep in the planet to twice the air's height, most of it near the two
            // edges.
            const double r = static_cast<double>(R) + static_cast<double>(altitude);
            const double edge = i % 4 == 1   ? 0.0
                                : i % 4 == 2 ? static_cast<double>(top)
                                             : random.uniform(-2e5, 2e5);
            const double offset = random.log_uniform(0.1, 1e5) * (random.below(2) == 0 ? 1 : -1);
            const double sine = std::fmin((static_cast<double>(R) + edge + offset) / r, 1.0);
            const vec3<double> u = vec3<double>(up_here);
            vec3<double> side = glm::cross(u, random.direction<double>());
            side /= std::sqrt(glm::dot(side, side));
            const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
            direction = vec3<float>(side * sine - u * cosine);
        }
        const vec3<long double> u = vec3<long double>(up_here);
        const vec3<long double> d = vec3<long double>(direction);
        const vec3<long double> across = glm::cross(u, d);
        const long double length = std::sqrt(glm::dot(u, u) * glm::dot(d, d));
        const long double sine = std::sqrt(glm::dot(across, across)) / length;
        const long double mu = glm::dot(u, d) / length;
        const long double h = altitude;
        const long double perigee = (R + h) * sine;
        // One rounding of a component tilts the ray by up to a roundoff and moves the perigee by |along|
        // times it; the length of the vectors, off by as much, moves it by the height above the ground and R
        // (1 - sine).
        const long double reach =
            3 * unit_roundoff<float>() * ((R + h) * std::fabs(mu) + h + R * mu * mu + (R + h) * 0x1p-24L);
        const bool in_air = h <= top || (mu < 0 && perigee < R + top);
        const bool ground = mu < 0 && perigee < R;
        const bool unclear_air = h > top && std::fabs(perigee - R - top) <= reach;
        const bool unclear_ground =
            std::fabs(perigee - R) <= reach || std::fabs(mu) <= 3 * unit_roundoff<float>();
        const ViewPath<float> path =
            view_path(planet, Viewpoint<float>{altitude, up_here}, direction, no_surface<float>());
        decided += unclear_air ? 0 : 1;
        decided += unclear_ground ? 0 : 1;
        wrong_air += !unclear_air && path.in_air != in_air ? 1 : 0;
        wrong_ground += !unclear_ground && path.reaches_ground != ground ? 1 : 0;
    }
    std::printf(
        "view_path<float>: %ld + %ld wrong decisions (air, ground) of %ld, a million rays, eyes 1 m to 1e8 "
        "m\n",
        wrong_air, wrong_ground, decided);
    CHECK(decided > 1600000);  // the rest is too close to an edge to call, mostly from beyond 1e6 m
    CHECK(wrong_air == 0);
    CHECK(wrong_ground == 0);
}

TEST_CASE("in float, the altitude along a ray is good to a centimetre up to 10 km") {
    Random random(85);
    const float radius = 6360000.0f;
    const long double R = radius;
    std::vector<double> errors;
    for (int i = 0; i < 200000; ++i) {
        const float h = static_cast<float>(random.log_uniform(1.0, 1e4));
        const float mu = i % 2 == 0 ? static_cast<float>(random.uniform(-1, 1))
                                    : static_cast<float>(random.uniform(-0.05, 0.05));
        const float along = (radius + h) * mu;
        const float t = static_cast<float>(random.log_uniform(1.0, 3e5));
        const long double w = static_cast<long double>(h) * (2 * R + h) +
                              static_cast<long double>(t) * (2 * static_cast<long double>(along) + t);
        const long double exact_altitude = w / (R + std::sqrt(R * R + w));
        if (exact_altitude < 0 || exact_altitude > 1e4L) {
            continue;
        }
        errors.push_back(static_cast<double>(
            std::fabs(static_cast<long double>(altitude_along_ray(radius, h, along, t)) - exact_altitude)));
    }
    const ErrorMetrics metrics = error_metrics(errors);
    std::printf(
        "altitude_along_ray<float>: altitude up to 10 km within %.2g m, 95 %% within %.2g m, median %.2g m, "
        "%zu rays\n",
        metrics.largest, metrics.p95, metrics.median, errors.size());
    CHECK(errors.size() > 50000);
    CHECK(metrics.largest <= 0.01);  // the accuracy that the design asks for
}

TEST_SUITE_END();
