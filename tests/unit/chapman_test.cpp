#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/chapman.hpp>
#include <airlight/constants.hpp>
#include <airlight/numeric.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using airlight::chapman;
using airlight::scaled_erfc;

namespace {

// chapman with the sine that belongs to mu.
template <typename T>
T chapman_upwards(T x, T mu) {
    return chapman(x, mu, airlight::safe_sqrt((T(1) - mu) * (T(1) + mu)));
}

// The docstring's error of the expansion, the fit of scaled_erfc included.
long double expansion_error(long double x) {
    if (x >= 200) {
        return 1e-7L;
    }
    return x >= 100 ? 5e-7L : x >= 50 ? 4e-6L : x >= 10 ? 3.3e-4L : x >= 5 ? 2e-3L : x >= 2 ? 2e-2L : 0.07L;
}

template <typename T>
constexpr long double roundoff() {
    return std::numeric_limits<T>::epsilon() / 2;
}

constexpr long double fit_error = 4.3e-8L;  // docstring of scaled_erfc

}  // namespace

TEST_SUITE_BEGIN("chapman");

TEST_CASE_TEMPLATE("scaled_erfc at 0 is the square root of pi", T, float, double, long double) {
    const long double expected = std::sqrt(airlight::pi<long double>);
    // The fit, and the rounding of its constant.
    CHECK_WITHIN(compare_relative("scaled_erfc", {{"x", 0}}, scaled_erfc(T(0)), expected),
                 fit_error + roundoff<T>());
}

TEST_CASE_TEMPLATE("scaled_erfc falls, between its two classical bounds", T, float, double, long double) {
    // 2 / (x + sqrt(x^2 + 2)) < sqrt(pi) exp(x^2) erfc(x) <= 2 / (x + sqrt(x^2 + 4 / pi)), DLMF 7.8.2.
    T before = std::numeric_limits<T>::infinity();
    const long double slack = fit_error + 8 * roundoff<T>();  // fit and rounding of the docstring
    for (int i = 0; i <= 700; ++i) {
        // From 0, then 3 % more each time up to 1e7: far more than the fit's ripple.
        const T x = i == 0 ? T(0) : T(std::exp(std::log(1e-2) + (i - 1) * std::log(1e9) / 699));
        const T got = scaled_erfc(x);
        const long double v = static_cast<long double>(x);
        CAPTURE(exact(v));
        CHECK(got < before);
        CHECK(static_cast<long double>(got) >= 2 / (v + std::sqrt(v * v + 2)) * (1 - slack));
        CHECK(static_cast<long double>(got) <=
              2 / (v + std::sqrt(v * v + 4 / airlight::pi<long double>)) * (1 + slack));
        before = got;
    }
}

TEST_CASE_TEMPLATE("straight up Chapman's function is 1", T, float, double, long double) {
    for (const T x : {T(10), T(50), T(100), T(800), T(5300), T(1e5L)}) {
        CHECK_WITHIN(
            compare_relative("chapman", {{"x", x}, {"mu", 1}}, chapman(x, T(1), T(0)), 1.0L),
            expansion_error(static_cast<long double>(x)) + 16 * roundoff<T>());  // both of the docstring
    }
}

TEST_CASE_TEMPLATE("level, Chapman's function is the square root of pi x / 2, and 3 / (8 x) more", T, float,
                   double, long double) {
    for (const T x : {T(100), T(800), T(5300), T(1e5L)}) {
        const long double v = static_cast<long double>(x);
        // x exp(x) K_1(x) by its asymptotic series, DLMF 10.40.2; the next term is 0.1 / x^3.
        const long double expected =
            std::sqrt(airlight::pi<long double> * v / 2) * (1 + 3 / (8 * v) - 15 / (128 * v * v));
        CHECK_WITHIN(
            compare_relative("chapman", {{"x", x}, {"mu", 0}}, chapman(x, T(0), T(1)), expected),
            expansion_error(v) + 0.11L / (v * v * v) + 16 * roundoff<T>());  // docstring, and that term
    }
}

TEST_CASE_TEMPLATE("around a huge planet the air is flat: Chapman's function is 1 / mu", T, float, double,
                   long double) {
    for (const T mu : {T(1), T(0.75), T(0.5), T(0.25)}) {
        const long double m = static_cast<long double>(mu);
        // The fit, 16 roundoffs as documented, and the bend: tan^2 / x, at most 1.5e-9.
        CHECK_WITHIN(
            compare_relative("chapman", {{"x", 1e10L}, {"mu", mu}}, chapman_upwards(T(1e10L), mu), 1 / m),
            fit_error + 1.5e-9L + 16 * roundoff<T>());
    }
}

TEST_CASE_TEMPLATE("Chapman's function falls as the ray rises", T, float, double, long double) {
    for (const T x : {T(50), T(100), T(800), T(5300), T(1e5L)}) {
        T before = std::numeric_limits<T>::infinity();
        for (int i = 0; i <= 500; ++i) {
            const T mu = T(i) / T(500);
            const T got = chapman_upwards(x, mu);
            CAPTURE(exact(static_cast<long double>(x)));
            CAPTURE(exact(static_cast<long double>(mu)));
            // A step of 1 / 500 is worth 2e-3 or more near mu = 1: far above the expansion's error.
            CHECK(got < before);
            before = got;
        }
    }
}

TEST_CASE_TEMPLATE("Chapman's function lies between 1 and 1 + sqrt(pi x / 2) for every x", T, float, double,
                   long double) {
    Random random(310);
    for (int i = 0; i < 20000; ++i) {
        const T x = T(random.log_uniform(1e-6, 1e9));
        const T mu = i % 20 == 0 ? T(i % 40 / 20) : T(random.uniform(0, 1));
        const T got = chapman_upwards(x, mu);
        CAPTURE(exact(static_cast<long double>(x)));
        CAPTURE(exact(static_cast<long double>(mu)));
        // Exact: the function adds no less than 0 to 1. NaN fails both.
        CHECK(got >= T(1));
        // Measured: the expansion stays 0.4 % below this at x = 1, more above it; below 1 it fades to 1.
        CHECK(got <= T(1) + glm::sqrt(T(0.5) * airlight::pi<T> * x));
    }
}

TEST_CASE("Leenman's formula for whole rays is that of a planet no larger than its air's scale height") {
    // T = 2 exp(-x) (2 - exp(-x)), x the ray's distance from the centre. He gives no unit; in scale heights
    // it is the column 2 x K_1(x) = 2 exp(-x) chapman(x, 0) of a ray through air of density exp(-r), r from
    // 0.
    Worst small;
    for (const Row& row : reference("chapman")) {
        if (row.text("function") != "chapman" || row.input<double>("mu") != 0) {
            continue;
        }
        const double x = row.input<double>("x");
        const double whole = std::exp(-x) * double(row.expected("value"));
        const double his = std::exp(-x) * (2 - std::exp(-x));
        CAPTURE(x);
        if (x <= 1) {
            small.add(compare_relative("his formula", {{"x", x}}, (long double)his, (long double)whole));
        }
        if (x >= 200 && whole > 0) {
            CHECK(his <
                  0.12 * whole);  // his falls as exp(-x), the column as sqrt(x) exp(-x): 2 / 17.7 at 200
            CHECK(std::exp(-x) * chapman(x, 0.0, 1.0) == doctest::Approx(whole).epsilon(1e-7));  // docstring
        }
    }
    small.print("of whole rays, x = 0.01 to 1");
    CHECK_WORST(small, 2.1e-2);  // modelling: a fit of two exponentials, worst at 0.5
}

TEST_CASE_TEMPLATE("scaled_erfc and Chapman's function agree with 50 digits", T, float, double, long double) {
    Worst erfc;
    Worst wide;  // x from 200 on
    Worst x_100;
    Worst x_50;
    Worst x_10;  // 10 and 20: here the expansion fades out
    Worst x_5;
    Worst x_2;
    Worst smaller;  // planets no larger than their air's scale height
    for (const Row& row : reference("chapman")) {
        const T x = row.input<T>("x");
        const T mu = row.input<T>("mu");
        if (row.text("function") == "scaled_erfc") {
            erfc.add(compare_relative("scaled_erfc", {{"x", x}}, scaled_erfc(x), row.expected("value")));
            continue;
        }
        Worst& worst = x >= T(200)   ? wide
                       : x >= T(100) ? x_100
                       : x >= T(50)  ? x_50
                       : x >= T(10)  ? x_10
                       : x >= T(5)   ? x_5
                       : x >= T(2)   ? x_2
                                     : smaller;
        worst.add(compare_relative("chapman", {{"x", x}, {"mu", mu}}, chapman_upwards(x, mu),
                                   row.expected("value")));
    }
    erfc.print("against 50 digits");
    wide.print("from x = 200 on");
    x_100.print("at x = 100");
    x_50.print("at x = 50");
    x_10.print("at x = 10 and 20");
    x_5.print("at x = 5");
    x_2.print("at x = 2");
    smaller.print("at x = 0.01 to 1");
    CHECK_WORST(erfc, fit_error + 8 * roundoff<T>());  // the fit and the roundoffs of the docstring
    CHECK_WORST(wide, expansion_error(200) + 16 * roundoff<T>());  // docstring of chapman, as the rest
    CHECK_WORST(x_100, expansion_error(100) + 16 * roundoff<T>());
    CHECK_WORST(x_50, expansion_error(50) + 16 * roundoff<T>());
    CHECK_WORST(x_10, expansion_error(10) + 16 * roundoff<T>());
    CHECK_WORST(x_5, expansion_error(5) + 16 * roundoff<T>());
    CHECK_WORST(x_2, expansion_error(2) + 16 * roundoff<T>());
    CHECK_WORST(smaller, expansion_error(1) + 16 * roundoff<T>());
}

TEST_CASE_TEMPLATE("below x = 1 Chapman's function fades to 1, which it is for a point", T, float, double,
                   long double) {
    for (const T mu : {T(0), T(0.25), T(1)}) {
        CHECK(chapman_upwards(T(0), mu) == T(1));  // exact: 1 and 0 times the rest
        CHECK(chapman_upwards(T(0.5), mu) <= chapman_upwards(T(1), mu));
    }
}

TEST_SUITE_END();
