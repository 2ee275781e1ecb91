#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/constants.hpp>
#include <airlight/sky_irradiance.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("sky_irradiance");

TEST_CASE_TEMPLATE("a level surface gets what comes down, its back what comes up, a wall the mean", T, float,
                   double, long double) {
    const SkyIrradiance<T> sky{vec3<T>(T(0.5)), vec3<T>(T(0.25)), vec3<T>(T(0))};
    // Exact: powers of two and sums of two.
    CHECK(sky_irradiance_on(sky, T(1), T(0.5), T(0.5)) == vec3<T>(T(0.5)));
    CHECK(sky_irradiance_on(sky, T(-1), T(0.5), T(-0.5)) == vec3<T>(T(0.25)));
    CHECK(sky_irradiance_on(sky, T(0), T(0.5), T(0)) == vec3<T>(T(0.375)));
}

TEST_CASE("radiance that is linear in the direction gives its irradiance on every surface") {
    // L = a + b . d over the sphere: E(n) = pi a + 2 pi / 3 b . n; the sun's side is +x.
    Random random(81);
    for (int i = 0; i < 1000; ++i) {
        const double mu_s = 1.9 * random.unit() - 0.95;
        const double s = std::sqrt((1 - mu_s) * (1 + mu_s));
        const double a = 1;
        const double bx = 0.6 * random.unit() - 0.3;
        const double bz = 0.6 * random.unit() - 0.3;
        const double third = 2 * pi<double> / 3;
        const SkyIrradiance<double> sky{vec3<double>(pi<double> * a + third * bz),
                                        vec3<double>(pi<double> * a - third * bz),
                                        vec3<double>(2 * third * bx / s)};
        const double nz = 2 * random.unit() - 1;
        const double nx = std::sqrt((1 - nz) * (1 + nz)) * (2 * random.unit() - 1);
        const double expected = pi<double> * a + third * (bx * nx + bz * nz);
        const double got = sky_irradiance_on(sky, nz, mu_s, nx * s + nz * mu_s).x;
        CHECK(std::fabs(got - expected) <= 1e-14);  // a dozen roundings of numbers near 4, over s >= 0.3
    }
}

TEST_CASE_TEMPLATE("a bent normal lies between normal and sun, at 0 and 1 on them", T, float, double,
                   long double) {
    const vec3<T> up(T(0), T(0), T(1));
    const vec3<T> level(T(1), T(0), T(0));
    CHECK(bent_normal(up, level, T(0)) == up);  // exact: the other is times 0
    CHECK(bent_normal(up, level, T(1)) == level);
    // 0.4 up and 0.6 level: 3 by 2, over the root of 13.
    const vec3<T> bent = bent_normal(up, level, T(0.6L));
    CHECK_WITHIN(compare_ulp("bent_normal.x", {}, bent.x, 3 / std::sqrt(13.0L)), 8.0L);
    CHECK_WITHIN(compare_ulp("bent_normal.z", {}, bent.z, 2 / std::sqrt(13.0L)), 8.0L);
    Random random(82);
    for (int i = 0; i < 10000; ++i) {
        const vec3<T> normal = random.direction<T>();
        const vec3<T> to_sun = random.direction<T>();
        const T bend = T(random.unit());
        const vec3<T> d = bent_normal(normal, to_sun, bend);
        const T rounding = 8 * std::numeric_limits<T>::epsilon();
        CHECK(std::fabs(dot_product(d, d) - 1) <= rounding);
        // In their plane, and no further from either than the other is.
        CHECK(std::fabs(dot_product(d, glm::cross(normal, to_sun))) <= rounding);
        const T between = dot_product(normal, to_sun);
        CHECK(dot_product(d, normal) >= between - rounding);
        CHECK(dot_product(d, to_sun) >= between - rounding);
    }
}

TEST_CASE_TEMPLATE("a bent normal without a direction is the normal", T, float, double, long double) {
    Random random(83);
    for (int i = 0; i < 1000; ++i) {
        const vec3<T> normal = random.direction<T>();
        CHECK(bent_normal(normal, -normal, T(0.5)) == normal);  // exact: a half of each is nothing
        // Past the half it is the sun's side, however little is left.
        const T past = T(0.5) + std::numeric_limits<T>::epsilon();
        CHECK(dot_product(bent_normal(normal, -normal, past), normal) < T(0));
    }
}

TEST_SUITE_END();
