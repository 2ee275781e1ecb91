#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/planet_shadow.hpp>
#include <airlight/transmittance.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
vec3<T> slope(double elevation_degrees) {
    const double e = elevation_degrees * 0.017453292519943295;
    return vec3<T>(T(std::cos(e)), T(0), T(std::sin(e)));
}

template <typename T>
Viewpoint<T> standing(T altitude) {
    return Viewpoint<T>{altitude, vec3<T>(T(0), T(0), T(1))};
}

template <typename T>
LineSpan<T> shadow_on(const Viewpoint<T>& eye, const vec3<T>& direction, const vec3<T>& to_sun, T shell) {
    const T radius = earth<T>().ground_radius;
    const T altitude = eye.altitude;
    const T mu = dot_product(eye.up, direction);
    const vec3<T> across = cross_of_unit_vectors(eye.up, direction);
    const T sine = std::sqrt(dot_product(across, across));
    const T perigee_altitude = altitude * sine - radius * (mu * mu / (T(1) + sine));
    return shadow_span(radius, perigee_altitude, sun_over_line(radius, eye, direction, to_sun), shell);
}

}  // namespace

TEST_SUITE_BEGIN("planet_shadow");

TEST_CASE_TEMPLATE("6 degrees after sunset the shadow ends 35.0 km overhead", T, float, double, long double) {
    const T radius = earth<T>().ground_radius;
    const vec3<T> sun = slope<T>(-6);
    const LineSpan<T> dark = shadow_on<T>(standing(T(0)), vec3<T>(T(0), T(0), T(1)), sun, T(0));
    // On the edge the distance from the shadow's axis, r cos 6, is the radius.
    const long double expected = radius / static_cast<long double>(sun.x) - radius;
    CHECK(expected / 35.03e3L == doctest::Approx(1).epsilon(1e-3));  // R / cos 6 - R, by hand
    // Roots to 8 roundoffs of the radius.
    CHECK_WITHIN(compare_relative("shadow_span.end", {}, dark.end - radius, expected),
                 4 * static_cast<long double>(std::numeric_limits<T>::epsilon()) * radius / expected);
    CHECK(dark.begin <= radius);
}

TEST_CASE_TEMPLATE("by day the ray overhead meets no shadow", T, float, double, long double) {
    const LineSpan<T> dark = shadow_on<T>(standing(T(0)), vec3<T>(T(0), T(0), T(1)), slope<T>(40), T(0));
    // Under the ground the line is in the shadow; above it is not.
    CHECK(dark.end <= T(0));
}

TEST_CASE_TEMPLATE("along the sunlight the shadow begins at the terminator and never ends", T, float, double,
                   long double) {
    const vec3<T> up(T(0), T(0), T(1));
    const LineSpan<T> away = shadow_on<T>(standing(T(2)), -up, up, T(0));
    CHECK(away.begin == T(0));  // exact: the closest approach is the centre
    CHECK(away.end == no_surface<T>());
    const LineSpan<T> towards = shadow_on<T>(standing(T(2)), up, up, T(0));
    CHECK(towards.begin == -no_surface<T>());
    CHECK(towards.end == T(0));
    // Past the planet the same line sees no shadow at all.
    const LineSpan<T> past = shadow_on<T>(standing(T(2)), slope<T>(0), slope<T>(0), T(0));
    CHECK(past.begin == past.end);
}

TEST_CASE_TEMPLATE("a point is in the stretch where behind_planet says so", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    Random random(621);
    int inside = 0;
    int outside = 0;
    int undecided = 0;
    for (int i = 0; i < 20000; ++i) {
        const Viewpoint<T> eye = {T(random.log_uniform(1, 1e6)), random.direction<T>()};
        const vec3<T> direction = random.direction<T>();
        const vec3<T> to_sun = random.direction<T>();
        const AirRay<T> ray = air_ray(air, eye, direction, no_surface<T>());
        if (!ray.in_air) {
            continue;
        }
        const SunOverLine<T> sun = sun_over_line(air.ground_radius, eye, direction, to_sun);
        const LineSpan<T> dark = shadow_span(air.ground_radius, ray.perigee_altitude, sun, T(0));
        const T t = ray.extent * T(random.unit());
        const T along = ray.along + t;
        const T altitude = glm::max(altitude_along_ray(air.ground_radius, ray.altitude, ray.along, t), T(0));
        const T mu = (sun.perigee_height + along * sun.cos_theta) / (air.ground_radius + altitude);
        const bool expected = behind_planet(air.ground_radius, altitude, glm::clamp(mu, T(-1), T(1)));
        // Where the shadow's edge passes within 100 roundoffs of the eye's radius, both may be right.
        const T slack = 100 * std::numeric_limits<T>::epsilon() * (air.ground_radius + eye.altitude) /
                        std::sqrt(sun.sin2_theta);
        if (std::fabs(along - dark.begin) < slack || std::fabs(along - dark.end) < slack) {
            ++undecided;
            continue;
        }
        const bool got = along > dark.begin && along < dark.end;
        CHECK_UNARY(got == expected);
        ++(expected ? inside : outside);
    }
    CHECK(inside > 1000);
    CHECK(outside > 1000);
    CHECK(undecided < 100);
}

TEST_CASE_TEMPLATE("the shadow of a higher shell holds that of a lower one", T, float, double, long double) {
    Random random(622);
    for (int i = 0; i < 3000; ++i) {
        const Viewpoint<T> eye = {T(random.log_uniform(1, 1e6)), random.direction<T>()};
        const vec3<T> direction = random.direction<T>();
        const vec3<T> to_sun = random.direction<T>();
        const LineSpan<T> low = shadow_on(eye, direction, to_sun, T(0));
        const LineSpan<T> high = shadow_on(eye, direction, to_sun, T(4e4));
        // Rounding of the roots, far smaller than the 40 km between the shells.
        const T slack = 16 * std::numeric_limits<T>::epsilon() * (glm::abs(low.begin) + glm::abs(low.end));
        if (low.begin < low.end) {
            CHECK_UNARY(high.begin <= low.begin + slack);
            CHECK_UNARY(high.end >= low.end - slack);
        }
    }
}

TEST_SUITE_END();
