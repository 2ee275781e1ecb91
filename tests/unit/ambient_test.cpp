#include <cmath>

#include <doctest/doctest.h>
#include <airlight/ambient.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("ambient");

TEST_CASE_TEMPLATE("a column of 1000 at 0.001 glows with 1 through nothing, and with 1 - 1/e through depth 1",
                   T, float, double, long double) {
    const vec3<T> glow = ambient_radiance(vec3<T>(T(0.5), T(0.5), T(0.25)), T(2), vec3<T>(T(0), T(1), T(2)));
    CHECK(glow.x == T(1));  // exact: powers of two, and depth 0 is the thin limit
    // one_minus_exp within 3 ulp, two products and a quotient: the docstring's 6.
    CHECK_WITHIN(
        compare_ulp("ambient_radiance", {{"depth", 1}}, glow.y, 0.632120558828557678404476229838539132555L),
        6.0L);
    CHECK_WITHIN(compare_ulp("ambient_radiance", {{"depth", 2}}, glow.z,
                             0.432332358381693654053000252513757798296L / 2),
                 6.0L);
}

TEST_CASE_TEMPLATE(
    "ambient light is linear in a thin ray and bounded by ambient_scattering C / tau in a thick one", T,
    float, double, long double) {
    Random random(121);
    for (int i = 0; i < 2000; ++i) {
        const T column = T(random.log_uniform(1, 1e6));
        const T depth = T(random.log_uniform(1e-9, 1e3));
        const vec3<T> glow = ambient_radiance(vec3<T>(T(1e-6L)), column, vec3<T>(depth));
        const vec3<T> thin = ambient_radiance(vec3<T>(T(1e-6L)), column, vec3<T>(T(0)));
        CHECK_UNARY(glow.x >= T(0));
        // Never more than the thin limit or 1 / tau of it; each side rounds by the docstring's 6 ulp.
        const T slack = T(1) + 6 * std::numeric_limits<T>::epsilon();
        CHECK_UNARY(glow.x <= thin.x * slack);
        CHECK_UNARY(glow.x <= thin.x / depth * slack);
        // Exact: a power of two.
        CHECK(ambient_radiance(vec3<T>(T(1e-6L)), column * 1024, vec3<T>(depth)) == glow * T(1024));
        // Scaling lengths: the coefficient falls as the column grows.
        CHECK(ambient_radiance(vec3<T>(T(1e-6L) / 1024), column * 1024, vec3<T>(depth)) == glow);
    }
}

TEST_CASE_TEMPLATE("the glow is (1 - exp(-tau)) / tau in every channel, down to no depth at all", T, float,
                   double, long double) {
    Random random(122);
    Worst worst;
    for (int i = 0; i < 20000; ++i) {
        const vec3<T> depth =
            vec3<T>(T(random.log_uniform(1e-30, 10)), T(random.log_uniform(1e-9, 100)), T(random.unit()));
        const vec3<T> glow = ambient_radiance(vec3<T>(T(1)), T(1), depth);
        for (int k = 0; k < 3; ++k) {
            const long double tau = depth[k];
            const long double expected = tau > 0 ? -std::expm1(-tau) / tau : 1.0L;
            worst.add(
                compare_ulp("ambient_radiance", {{"depth", tau}, {"channel", T(k)}}, glow[k], expected));
        }
    }
    worst.print("against expm1");
    CHECK_WORST(worst,
                6.0L + 2 * table_rounding<T>());  // the docstring's bound; expm1 and its quotient round too
}

TEST_CASE_TEMPLATE("no ambient light or no air, no glow", T, float, double, long double) {
    CHECK(ambient_radiance(vec3<T>(T(0)), T(5), vec3<T>(T(1))) == vec3<T>(T(0)));
    CHECK(ambient_radiance(vec3<T>(T(1)), T(0), vec3<T>(T(0))) == vec3<T>(T(0)));
}

TEST_SUITE_END();
