#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/density.hpp>

#include "quadrature.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using airlight::exponential_density;
using airlight::lorentzian_density;
using airlight::tent_density;

TEST_SUITE_BEGIN("density");

TEST_CASE_TEMPLATE("one scale height up the density is 1/e", T, float, double, long double) {
    const T got = exponential_density(T(8000), T(8000));
    // exp within 1 ulp of its exact argument -1.
    CHECK_WITHIN(compare_ulp("exponential_density", {{"altitude", 8000}, {"scale_height", 8000}}, got,
                             0.367879441171442321595523770161460867446L),
                 1.0L + table_rounding<T>());
    CHECK(exponential_density(T(0), T(8000)) == T(1));  // exact: exp(0)
}

TEST_CASE_TEMPLATE("the tent is 1 at its centre, 1/2 half way down and 0 from its foot on", T, float, double,
                   long double) {
    CHECK(tent_density(T(25000), T(25000), T(15000)) == T(1));    // exact: the offset is 0
    CHECK(tent_density(T(32500), T(25000), T(15000)) == T(0.5));  // exact: 7500 / 15000
    CHECK(tent_density(T(17500), T(25000), T(15000)) == T(0.5));
    CHECK(tent_density(T(40000), T(25000), T(15000)) == T(0));
    CHECK(tent_density(T(10000), T(25000), T(15000)) == T(0));
    CHECK(tent_density(T(90000), T(25000), T(15000)) == T(0));
}

TEST_CASE_TEMPLATE("the Lorentz profile is 1 at its centre and 1/2 at its half width", T, float, double,
                   long double) {
    CHECK(lorentzian_density(T(30000), T(30000), T(4000)) == T(1));    // exact: 1 / (1 + 0)
    CHECK(lorentzian_density(T(34000), T(30000), T(4000)) == T(0.5));  // exact: 1 / (1 + 1)
    CHECK(lorentzian_density(T(26000), T(30000), T(4000)) == T(0.5));
    CHECK(lorentzian_density(T(42000), T(30000), T(4000)) == T(0.1L));  // correctly rounded 1 / (1 + 9)
}

TEST_CASE_TEMPLATE("densities lie between 0 and 1, and the exponential one falls with altitude", T, float,
                   double, long double) {
    Random random(31);
    for (int i = 0; i < 5000; ++i) {
        const T h = T(random.uniform(-1e5, 2e5));
        const T centre = T(random.uniform(0, 5e4));
        const T width = T(random.log_uniform(0.1, 1e6));
        const T densities[] = {exponential_density(h, width), tent_density(h, centre, width),
                               lorentzian_density(h, centre, width)};
        for (const T density : densities) {
            CHECK_UNARY(density >= T(0) && density <= T(1));
        }
        CHECK_UNARY(exponential_density(h + width, width) <= densities[0]);
    }
}

TEST_CASE_TEMPLATE("both layers are symmetric about their centre", T, float, double, long double) {
    for (const T offset : {T(1), T(500), T(4096), T(12000)}) {
        // Exact: the centre and the offset are integers, so both altitudes and differences are exact.
        CHECK(tent_density(T(25000) + offset, T(25000), T(15000)) ==
              tent_density(T(25000) - offset, T(25000), T(15000)));
        CHECK(lorentzian_density(T(25000) + offset, T(25000), T(15000)) ==
              lorentzian_density(T(25000) - offset, T(25000), T(15000)));
    }
}

TEST_CASE_TEMPLATE("a vertical column holds one scale height, or one half width of the tent", T, float,
                   double, long double) {
    // The integrand is rounded at every altitude, by 3 roundoffs at most; the rule's weights are positive,
    // so the sum is off by no more than that, and by the exp(-60) that is cut off.
    const long double exponential =
        integrate([](long double h) { return static_cast<long double>(exponential_density(T(h), T(1))); },
                  0.0L, 60.0L, 0x1p-20L * unit_roundoff<T>());
    // T(h) rounds the altitude as well: d(rho)/dh h, at most 1/e of a roundoff more.
    CHECK_WITHIN(compare_roundoffs("integral of exponential_density", {}, T(exponential), 1.0L, 1.0L), 5.0L);
    const auto tent = [](long double h) {
        return static_cast<long double>(tent_density(T(h), T(25), T(15)));
    };
    const long double area =
        integrate(tent, 10.0L, 25.0L, unit_roundoff<T>()) + integrate(tent, 25.0L, 40.0L, unit_roundoff<T>());
    // The rounding of h costs 40 / 15 roundoffs of the profile's value 1, over twice the half width.
    CHECK_WITHIN(compare_roundoffs("integral of tent_density", {}, T(area), 15.0L, 30.0L * 40.0L / 15.0L),
                 4.0L);
}

TEST_CASE_TEMPLATE("densities do not depend on the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two cancels in every quotient
    Random random(32);
    for (int i = 0; i < 2000; ++i) {
        const T h = T(random.uniform(-1e3, 1e5));
        const T c = T(random.uniform(0, 5e4));
        const T w = T(random.log_uniform(10, 1e5));
        CHECK(exponential_density(k * h, k * w) == exponential_density(h, w));
        CHECK(tent_density(k * h, k * c, k * w) == tent_density(h, c, w));
        CHECK(lorentzian_density(k * h, k * c, k * w) == lorentzian_density(h, c, w));
    }
}

TEST_CASE_TEMPLATE("densities agree with 50 digits", T, float, double, long double) {
    Worst exponential;
    Worst tent;
    Worst lorentzian;
    for (const Row& row : reference("density")) {
        const T h = row.input<T>("h");
        const T p = row.input<T>("p");
        const T q = row.input<T>("q");
        const long double expected = row.expected("expected");
        const long double condition = row.expected("condition");
        if (row.text("function") == "exponential") {
            exponential.add(compare_roundoffs("exponential_density", {{"altitude", h}, {"scale_height", p}},
                                              exponential_density(h, p), expected, condition));
        } else if (row.text("function") == "tent") {
            tent.add(compare_roundoffs("tent_density", {{"altitude", h}, {"centre", p}, {"half_width", q}},
                                       tent_density(h, p, q), expected, condition));
        } else {
            lorentzian.add(compare_roundoffs("lorentzian_density",
                                             {{"altitude", h}, {"centre", p}, {"half_width", q}},
                                             lorentzian_density(h, p, q), expected, condition));
        }
    }
    exponential.print("against 50 digits");
    tent.print("against 50 digits");
    lorentzian.print("against 50 digits");
    // One rounded quotient times its condition, and exp's own ulp (two roundoffs).
    CHECK_WORST(exponential, 2.0L + table_rounding<T>());
    // Difference and quotient are rounded within the condition, the final difference adds one.
    CHECK_WORST(tent, 2.0L + table_rounding<T>());
    // Difference, quotient, square, sum, reciprocal: five roundoffs, the first two doubled by the square.
    CHECK_WORST(lorentzian, 4.0L + table_rounding<T>());
}

TEST_CASE_TEMPLATE("below the ground the air is as dense as at the ground, never denser or thinner", T, float,
                   double, long double) {
    // Our reading of sources that clamp the altitude in one place and take its absolute value in another:
    // one rule, clamp at the ground.
    for (const T depth : {T(1), T(1000), T(6371000), T(1e12L)}) {
        CHECK(exponential_density(-depth, T(8000)) == T(1));  // exact: the same call
        CHECK(tent_density(-depth, T(25000), T(15000)) == tent_density(T(0), T(25000), T(15000)));
        CHECK(tent_density(-depth, T(5000), T(15000)) == tent_density(T(0), T(5000), T(15000)));
        CHECK(lorentzian_density(-depth, T(30000), T(4000)) == lorentzian_density(T(0), T(30000), T(4000)));
    }
}

TEST_CASE_TEMPLATE("a layer without thickness holds nothing, at any altitude", T, float, double,
                   long double) {
    for (const T h : {T(-5), T(0), T(1), T(25000), T(1e9L)}) {
        CHECK(exponential_density(h, T(0)) == T(0));
        CHECK(tent_density(h, T(25000), T(0)) == T(0));
        CHECK(lorentzian_density(h, T(25000), T(0)) == T(0));
    }
}

TEST_CASE_TEMPLATE("far above the planet there is nothing left, down to the last denormal", T, float, double,
                   long double) {
    const T infinity = std::numeric_limits<T>::infinity();
    CHECK(exponential_density(T(1e6L), T(0.1L)) == T(0));
    CHECK(exponential_density(infinity, T(8000)) == T(0));
    CHECK(tent_density(infinity, T(25000), T(15000)) == T(0));
    CHECK(lorentzian_density(infinity, T(30000), T(4000)) == T(0));
}

TEST_SUITE_END();
