#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/ray_sphere.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using airlight::intersect_ray_sphere;
using airlight::RaySphereHit;

namespace {

struct Ray {
    double radius;
    double altitude;
    double mu;
};

// Rays from 1 m to 1e9 m up, half of them close to the horizon, and from inside the sphere.
template <typename Function>
void for_each_ray(int count, Function function) {
    Random random(41);
    for (int i = 0; i < count; ++i) {
        const double radius = random.log_uniform(100.0, 7e7);
        const bool inside = random.below(4) == 0;
        const double altitude = inside ? -radius * random.unit() : random.log_uniform(1.0, 1e9);
        double mu = random.uniform(-1.0, 1.0);
        if (!inside && random.below(2) == 0) {
            const double sine = radius / (radius + altitude) * random.uniform(0.99, 1.01);
            mu = sine < 1.0 ? -std::sqrt((1.0 - sine) * (1.0 + sine)) : 0.0;
        }
        function(Ray{radius, altitude, mu});
    }
}

}  // namespace

TEST_SUITE_BEGIN("ray_sphere");

TEST_CASE_TEMPLATE("a ray straight down from 2 m hits the ground after 2 m", T, float, double, long double) {
    const T h = T(0.002L);  // km
    const RaySphereHit<T> hit = intersect_ray_sphere(T(6371), h, T(-1));
    REQUIRE(hit.hit);
    CHECK(hit.t_near == h);  // exact: h (2 R + h) / (2 R + h), both rounded alike
    // The far side: a diameter and 2 m on, one rounding of the sum of root and half chord.
    CHECK_WITHIN(compare_ulp("intersect_ray_sphere.t_far", {{"altitude", h}}, hit.t_far,
                             12742.0L + static_cast<long double>(h)),
                 1.0L + table_rounding<T>());
}

TEST_CASE_TEMPLATE(
    "a 3-4-5 triangle: 4 from the centre of a sphere of radius 5, sideways, it is 3 to the wall", T, float,
    double, long double) {
    const RaySphereHit<T> across = intersect_ray_sphere(T(5), T(-1), T(0));
    REQUIRE(across.hit);
    CHECK(across.t_near == T(-3));  // exact: every step is an integer
    CHECK(across.t_far == T(3));
}

TEST_CASE_TEMPLATE("from the centre every direction leads to the surface after one radius", T, float, double,
                   long double) {
    for (const T mu : {T(-1), T(-0.5), T(0), T(0.25), T(1)}) {
        const RaySphereHit<T> hit = intersect_ray_sphere(T(6371), T(-6371), mu);
        REQUIRE(hit.hit);
        // sin^2 + cos^2 are rounded three times before they make up the discriminant.
        CHECK_WITHIN(compare_ulp("intersect_ray_sphere.t_far", {{"mu", mu}}, hit.t_far, 6371.0L), 3.0L);
        CHECK_WITHIN(compare_ulp("intersect_ray_sphere.t_near", {{"mu", mu}}, hit.t_near, -6371.0L), 3.0L);
    }
}

TEST_CASE_TEMPLATE("both crossings are returned, tagged, wherever the ray starts", T, float, double,
                   long double) {
    // Our reading of a source that leaves the far crossing unset for a start inside the sphere.
    const RaySphereHit<T> inside = intersect_ray_sphere(T(6371), T(-100), T(0.5));
    CHECK(inside.hit);
    CHECK(inside.t_near < T(0));
    CHECK(inside.t_far > T(0));
    const RaySphereHit<T> ahead = intersect_ray_sphere(T(6371), T(100), T(-1));
    CHECK(ahead.hit);
    CHECK(ahead.t_near > T(0));
    CHECK(ahead.t_far > ahead.t_near);
    const RaySphereHit<T> behind = intersect_ray_sphere(T(6371), T(100), T(1));
    CHECK(behind.hit);
    CHECK(behind.t_near < behind.t_far);
    CHECK(behind.t_far < T(0));
    const RaySphereHit<T> miss = intersect_ray_sphere(T(6371), T(100), T(0));
    CHECK_FALSE(miss.hit);
    CHECK(miss.t_near == T(0));
    CHECK(miss.t_far == T(0));
}

TEST_CASE_TEMPLATE("turning round swaps the crossings and their signs", T, float, double, long double) {
    for_each_ray(20000, [](const Ray& ray) {
        const T radius = T(ray.radius);
        const T h = T(ray.altitude);
        const T mu = T(ray.mu);
        const RaySphereHit<T> a = intersect_ray_sphere(radius, h, mu);
        const RaySphereHit<T> b = intersect_ray_sphere(radius, h, -mu);
        if (mu != T(0)) {
            // Exact: only the sign of `along` differs.
            CHECK_UNARY(a.hit == b.hit);
            CHECK_EQUAL(compare_ulp("intersect_ray_sphere.t_near",
                                    {{"radius", radius}, {"altitude", h}, {"mu", mu}}, b.t_near, -a.t_far));
            CHECK_EQUAL(compare_ulp("intersect_ray_sphere.t_far",
                                    {{"radius", radius}, {"altitude", h}, {"mu", mu}}, b.t_far, -a.t_near));
        }
    });
}

TEST_CASE_TEMPLATE("distances scale exactly with the unit of length", T, float, double, long double) {
    const T k = 1024;  // a power of two: scaling rounds nothing, so == is the right test
    for_each_ray(20000, [k](const Ray& ray) {
        const T radius = T(ray.radius);
        const T h = T(ray.altitude);
        const T mu = T(ray.mu);
        const RaySphereHit<T> a = intersect_ray_sphere(radius, h, mu);
        const RaySphereHit<T> b = intersect_ray_sphere(k * radius, k * h, mu);
        CHECK_UNARY(b.hit == a.hit);
        CHECK_EQUAL(compare_ulp("intersect_ray_sphere.t_near",
                                {{"radius", radius}, {"altitude", h}, {"mu", mu}}, b.t_near, k * a.t_near));
        CHECK_EQUAL(compare_ulp("intersect_ray_sphere.t_far",
                                {{"radius", radius}, {"altitude", h}, {"mu", mu}}, b.t_far, k * a.t_far));
    });
}

TEST_CASE_TEMPLATE("crossings agree with 50 digits, to the exact answer for inputs moved by 3 roundoffs", T,
                   float, double, long double) {
    Worst worst;
    for (const Row& row : reference("ray_sphere")) {
        const T radius = row.input<T>("radius");
        const T h = row.input<T>("altitude");
        const T mu = row.input<T>("mu");
        const RaySphereHit<T> hit = intersect_ray_sphere(radius, h, mu);
        CAPTURE(exact(radius));
        CAPTURE(exact(h));
        CAPTURE(exact(mu));
        REQUIRE(hit.hit == (row.text("hit") == "1"));
        if (hit.hit) {
            worst.add(compare_roundoffs("intersect_ray_sphere.t_near",
                                        {{"radius", radius}, {"altitude", h}, {"mu", mu}}, hit.t_near,
                                        row.expected("t_near"), row.expected("condition_near")));
            worst.add(compare_roundoffs("intersect_ray_sphere.t_far",
                                        {{"radius", radius}, {"altitude", h}, {"mu", mu}}, hit.t_far,
                                        row.expected("t_far"), row.expected("condition_far")));
        }
    }
    worst.print("against 50 digits");
    CHECK_WORST(worst, 3.0L + table_rounding<T>());  // the docstring's bound
}

TEST_CASE("in float no ray from 1 m to 1e9 m is sent wrong by the function") {
    // Against the textbook form in long double (65 bits hold it: the worst cancellation costs 34 of them).
    // Left out are rays whose decision 2 roundoffs of the inputs could flip.
    long decided = 0;
    long wrong = 0;
    for_each_ray(200000, [&](const Ray& ray) {
        const float radius = static_cast<float>(ray.radius);
        const float h = static_cast<float>(ray.altitude);
        const float mu = static_cast<float>(ray.mu);
        const long double R = radius;
        const long double r = R + static_cast<long double>(h);
        const long double m = mu;
        const long double sine = std::sqrt((1 - m) * (1 + m));
        const long double gap = R - r * sine;
        // Moves of the gap when radius, altitude and mu each move by their own size.
        const long double condition = R * (1 - sine) + std::fabs(static_cast<long double>(h)) * sine +
                                      r * m * m / (sine > 0 ? sine : 1);
        if (std::fabs(gap) <= 2 * unit_roundoff<float>() * condition) {
            return;
        }
        ++decided;
        wrong += intersect_ray_sphere(radius, h, mu).hit != (gap > 0) ? 1 : 0;
    });
    std::printf("intersect_ray_sphere<float>: %ld wrong decisions of %ld\n", wrong, decided);
    CHECK(decided > 190000);
    CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("a tangent ray counts as a hit", T, float, double, long double) {
    const RaySphereHit<T> hit = intersect_ray_sphere(T(6371), T(0), T(0));
    CHECK(hit.hit);  // as the docstring promises; exact: the gap is 0
    CHECK(hit.t_near == T(0));
    CHECK(hit.t_far == T(0));
}

TEST_CASE_TEMPLATE("a bad cosine or NaN stays visible", T, float, double, long double) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const RaySphereHit<T> hits[] = {
        intersect_ray_sphere(T(6371), T(100), T(1.5)), intersect_ray_sphere(T(6371), T(100), T(-2)),
        intersect_ray_sphere(T(6371), T(100), nan), intersect_ray_sphere(T(6371), nan, T(-1)),
        intersect_ray_sphere(nan, T(100), T(-1))};
    for (const RaySphereHit<T>& hit : hits) {
        CHECK(hit.hit);
        CHECK(std::isnan(hit.t_near));
        CHECK(std::isnan(hit.t_far));
    }
}

TEST_CASE_TEMPLATE("on the surface one crossing is the start itself", T, float, double, long double) {
    for (const T mu : {T(-0.75), T(-0.001L), T(0.001L), T(0.75)}) {
        const RaySphereHit<T> hit = intersect_ray_sphere(T(6371), T(0), mu);
        REQUIRE(hit.hit);
        CHECK((mu < T(0) ? hit.t_near : hit.t_far) == T(0));  // exact: the product of the roots is 0
        // The other is the chord 2 R |mu|.
        const T chord = mu < T(0) ? hit.t_far : -hit.t_near;
        CHECK_WITHIN(compare_ulp("intersect_ray_sphere", {{"mu", mu}}, chord, 2 * 6371.0L * std::fabs(mu)),
                     4.0L);
    }
}

TEST_SUITE_END();
