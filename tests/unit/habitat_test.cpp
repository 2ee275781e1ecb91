#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/arc_tangent.hpp>
#include <airlight/habitat.hpp>
#include <airlight/habitats.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
HabitatAir<T> with_rise(T rise, T radius) {
    HabitatAir<T> air = rama_air<T>();
    air.density_rise = rise;
    air.radius = radius;
    return air;
}

template <typename T>
constexpr long double roundoff() {
    return std::numeric_limits<T>::epsilon() / 2;
}

}  // namespace

TEST_SUITE_BEGIN("habitat");

TEST_CASE_TEMPLATE("on the axis of a habitat with Earth's weight at its wall there is 62 % of the wall's air",
                   T, float, double, long double) {
    const HabitatAir<T> air = rama_air<T>();
    // k R^2 = g R / (2 R_s T) = 9.81 * 8000 / (2 * 287.05 * 288.15), by hand.
    const long double logarithm = 9.81L * 8000 / (2 * 287.05L * 288.15L);
    CHECK(std::fabs(static_cast<long double>(habitat_log_density(air, vec3<T>(T(0)))) + logarithm) <=
          16 * roundoff<T>());  // six operations on rounded inputs
    CHECK(double(habitat_density(air, vec3<T>(T(1000), T(0), T(0)))) ==
          doctest::Approx(0.6224).epsilon(1e-4));
    CHECK(double(habitat_density(air, vec3<T>(T(0), T(0), T(-8000)))) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE_TEMPLATE("the spin that gives the wall Earth's weight turns 8 km once in three minutes", T, float,
                   double, long double) {
    CHECK(double(T(2) * pi<T> / spin_for_gravity(T(8000), T(9.81L))) == doctest::Approx(179.4).epsilon(1e-3));
}

TEST_CASE_TEMPLATE("without spin the column is the way", T, float, double, long double) {
    const HabitatAir<T> air = with_rise<T>(T(0), T(8000));
    for (const T length : {T(0), T(1e-3L), T(1), T(4e4L)}) {
        const T got = habitat_column(air, vec3<T>(T(0)), vec3<T>(length, T(0), T(0)));
        CHECK(double(got) == doctest::Approx(double(length)).epsilon(1e-6));
    }
}

TEST_CASE_TEMPLATE("a column is the same in both directions, and the sum of its parts", T, float, double) {
    Random random(600);
    const HabitatAir<T> air = rama_air<T>();
    for (int i = 0; i < 2000; ++i) {
        const auto place = [&random] {
            const double x = random.uniform(-24e3, 24e3);
            const double y = random.uniform(-5600, 5600);
            const double z = random.uniform(-5600, 5600);
            return vec3<T>(T(x), T(y), T(z));
        };
        const vec3<T> a = place();
        const vec3<T> b = place();
        const vec3<T> c = a + T(0.3L) * (b - a);
        const double whole = double(habitat_column(air, a, b));
        CHECK(double(habitat_column(air, b, a)) == doctest::Approx(whole).epsilon(1e-6));  // float's own
        const double parts = double(habitat_column(air, a, c) + habitat_column(air, c, b));
        CHECK(parts == doctest::Approx(whole).epsilon(1e-6));  // three columns of 3e-7, and c is rounded
    }
}

TEST_CASE_TEMPLATE(
    "all that passes comes back: transmittance is the same in both directions and falls with the way", T,
    float, double) {
    const HabitatAir<T> air = rama_air<T>();
    const vec3<T> eye(T(-20e3L), T(0), T(-7990));
    T before = T(2);
    for (int i = 0; i <= 40; ++i) {
        const vec3<T> there = eye + T(i) * vec3<T>(T(1000), T(30), T(200));
        const T passed = habitat_transmittance(air, eye, there).z;
        CHECK(passed < before);
        CHECK(passed > T(0));
        before = passed;
    }
    CHECK(habitat_transmittance(air, eye, eye).x == T(1));  // exact: exp(-0)
}

TEST_CASE_TEMPLATE("Dawson's integral, the arc tangent and the column agree with 50 digits", T, float, double,
                   long double) {
    Worst dawson_worst;
    Worst dawson_far;
    Worst angles;
    Worst columns;
    Worst strong;
    for (const Row& row : reference("habitat")) {
        const T first = row.input<T>("rise");
        const T second = row.input<T>("radius");
        const long double expected = row.expected("value");
        if (row.text("function") == "dawson") {
            Worst& worst = glm::abs(first) > T(300) ? dawson_far : dawson_worst;
            worst.add(compare_relative("dawson", {{"x", first}}, dawson(first), expected));
        } else if (row.text("function") == "arc_tangent") {
            angles.add(compare_relative("arc_tangent", {{"y", first}, {"x", second}},
                                        arc_tangent(first, second), expected));
        } else {
            const vec3<T> a(row.input<T>("ax"), row.input<T>("ay"), row.input<T>("az"));
            const vec3<T> b(row.input<T>("bx"), row.input<T>("by"), row.input<T>("bz"));
            const T got = habitat_column(with_rise<T>(first, second), a, b);
            Worst& worst = first * second * second < T(1) ? columns : strong;
            worst.add(compare_relative("habitat_column",
                                       {{"rise", first},
                                        {"ax", a.x},
                                        {"ay", a.y},
                                        {"az", a.z},
                                        {"bx", b.x},
                                        {"by", b.y},
                                        {"bz", b.z}},
                                       got, expected));
        }
    }
    dawson_worst.print("to 300");
    dawson_far.print("beyond 300");
    angles.print("all quadrants");
    columns.print("in the document's habitat");
    strong.print("of spins up to ten times as fast");
    CHECK_WORST(dawson_worst, 1.1e-7L + 12 * roundoff<T>());  // docstring, as the rest
    CHECK_WORST(dawson_far, 6e-6L + 12 * roundoff<T>());
    CHECK_WORST(angles, 2.1e-8L + 8 * roundoff<T>());
    CHECK_WORST(columns, 3e-7L + 32 * roundoff<T>());
    CHECK_WORST(strong, 3e-7L + (24 + 8 * 50) * roundoff<T>());
}

TEST_CASE_TEMPLATE("a ray from the axis meets the wall after the radius, one along it the cap", T, float,
                   double, long double) {
    const CylinderHit<T> wall =
        intersect_capped_cylinder(T(8), T(24), vec3<T>(T(0)), vec3<T>(T(0), T(0), T(1)));
    CHECK(wall.hit);
    CHECK(wall.t_near == T(-8));  // exact: roots of t^2 = 64
    CHECK(wall.t_far == T(8));
    const CylinderHit<T> cap =
        intersect_capped_cylinder(T(8), T(24), vec3<T>(T(4), T(0), T(0)), vec3<T>(T(1), T(0), T(0)));
    CHECK(cap.hit);
    CHECK(cap.t_near == T(-28));
    CHECK(cap.t_far == T(20));
    const CylinderHit<T> beside =
        intersect_capped_cylinder(T(8), T(24), vec3<T>(T(0), T(9), T(0)), vec3<T>(T(1), T(0), T(0)));
    CHECK_FALSE(beside.hit);
    const CylinderHit<T> outside =
        intersect_capped_cylinder(T(8), T(24), vec3<T>(T(0), T(0), T(-16)), vec3<T>(T(0), T(0), T(1)));
    CHECK(outside.hit);
    CHECK(outside.t_near == T(8));
    CHECK(outside.t_far == T(24));
    const CylinderHit<T> past =
        intersect_capped_cylinder(T(8), T(24), vec3<T>(T(25), T(0), T(0)), vec3<T>(T(0), T(0), T(1)));
    CHECK_FALSE(past.hit);
}

TEST_CASE_TEMPLATE("the far end of a ray inside lies on the wall or on a cap", T, float, double) {
    Random random(601);
    for (int i = 0; i < 20000; ++i) {
        const double radius = random.log_uniform(1, 1e5);
        const double half = random.log_uniform(1, 1e5);
        const double angle = random.uniform(0, 6.283);
        const double from_axis = radius * std::sqrt(random.uniform(0, 1));
        const double x = random.uniform(-half, half);
        const vec3<T> eye(T(x), T(from_axis * std::cos(angle)), T(from_axis * std::sin(angle)));
        const vec3<T> direction = vec3<T>(random.direction<T>());
        const CylinderHit<T> hit = intersect_capped_cylinder(T(radius), T(half), eye, direction);
        REQUIRE(hit.hit);
        const vec3<T> end = eye + hit.t_far * direction;
        const double reach =
            std::max(std::hypot(double(end.y), double(end.z)) / radius, std::fabs(double(end.x)) / half);
        CHECK(reach ==
              doctest::Approx(1).epsilon(2e-5));  // long thin cylinders: roundoffs of the longer side
    }
}

TEST_CASE_TEMPLATE("absurd habitats give finite air", T, float, double) {
    Random random(602);
    const T sizes[] = {T(0), T(1e-6L), T(1), T(8000), T(1e9L)};
    const T rises[] = {T(0), T(1e-30L), T(1e-9L), T(1e-3L)};
    for (const T radius : sizes) {
        for (const T rise : rises) {
            if (rise * radius * radius > T(1e4L)) {
                continue;  // the density at the axis is below anything's range, and behind the wall above it
            }
            const HabitatAir<T> air = with_rise<T>(rise, radius);
            for (int i = 0; i < 200; ++i) {
                const auto inside = [&] {
                    const double x = random.uniform(-1, 1);
                    const double y = random.uniform(-0.7, 0.7);
                    const double z = random.uniform(-0.7, 0.7);
                    return radius * vec3<T>(T(x), T(y), T(z));
                };
                const vec3<T> a = inside();
                const vec3<T> b = i % 4 == 0 ? a : i % 4 == 1 ? vec3<T>(T(0.5) * a.x, a.y, a.z) : inside();
                const T column = habitat_column(air, a, b);
                CHECK(std::isfinite(column));
                CHECK(column >= T(0));
                CHECK(column <= T(1.01L) * glm::length(b - a));  // nowhere denser than at the wall
                const vec3<T> direction = vec3<T>(random.direction<T>());
                const CylinderHit<T> hit = intersect_capped_cylinder(radius, radius, a, direction);
                CHECK_FALSE(std::isnan(hit.t_near));
                CHECK_FALSE(std::isnan(hit.t_far));
            }
        }
    }
}

TEST_SUITE_END();
