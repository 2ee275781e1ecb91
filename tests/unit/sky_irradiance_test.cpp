#include <cmath>

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

TEST_SUITE_END();
