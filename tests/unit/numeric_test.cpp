#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/numeric.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using airlight::cross_of_unit_vectors;
using airlight::one_minus_exp;
using airlight::safe_sqrt;
using airlight::vec3;

TEST_SUITE_BEGIN("numeric");

TEST_CASE_TEMPLATE("one_minus_exp of ln 2 is one half", T, float, double, long double) {
    const T ln2 = T(0.693147180559945309417232121458176568L);
    // 3 ulp of the function plus the rounding of ln 2, which moves the result by less than 1.
    CHECK_WITHIN(compare_ulp("one_minus_exp", {{"x", ln2}}, one_minus_exp(ln2), 0.5L), 4.0L);
}

TEST_CASE_TEMPLATE("nothing is lost over no depth, everything over an infinite one", T, float, double,
                   long double) {
    CHECK(one_minus_exp(T(0)) == T(0));                                // exact: the numerator is 2 x
    CHECK(one_minus_exp(std::numeric_limits<T>::infinity()) == T(1));  // exact: exp(-infinity) is 0
    CHECK(one_minus_exp(std::numeric_limits<T>::max()) == T(1));
}

TEST_CASE_TEMPLATE("one_minus_exp is x itself for a thin medium", T, float, double, long double) {
    // 1 - exp(-x) = x - x^2 / 2 + ...: below x = half a roundoff the difference is under half an ulp.
    for (T x = std::numeric_limits<T>::epsilon() / 4; x > std::numeric_limits<T>::min(); x /= T(1024)) {
        CHECK_WITHIN(compare_ulp("one_minus_exp", {{"x", x}}, one_minus_exp(x), x),
                     2.0L);  // division and sum round
    }
}

TEST_CASE_TEMPLATE("more depth never loses less, across the change of method too", T, float, double,
                   long double) {
    Random random(11);
    Worst worst;
    for (int i = 0; i < 20000; ++i) {
        const T x = T(random.uniform(0.0, 2.0));
        const T y = x + T(random.uniform(0.0, 0.01));
        const T fx = one_minus_exp(x);
        const T fy = one_minus_exp(y);
        REQUIRE(fx >= T(0));
        REQUIRE(fy <= T(1));
        // Each value may be off by 3 ulp (its docstring), so a step back of up to 6 is rounding.
        const T back = fy < fx ? fy : fx;
        worst.add(compare_ulp("one_minus_exp", {{"x", x}, {"y", y}}, back, fx));
    }
    CHECK_WORST(worst, 6.0L);
}

TEST_CASE_TEMPLATE("one_minus_exp agrees with 50 digits within 3 ulp", T, float, double, long double) {
    Worst worst;
    for (const Row& row : reference("numeric")) {
        const T x = row.input<T>("x");
        worst.add(compare_ulp("one_minus_exp", {{"x", x}}, one_minus_exp(x), row.expected("one_minus_exp")));
    }
    worst.print("against 50 digits");
    CHECK_WORST(worst, 3.0L + table_rounding<T>());  // the docstring's bound
}

TEST_CASE_TEMPLATE("one_minus_exp agrees with the C library's expm1 in long double over a dense sweep", T,
                   float, double) {
    Random random(14);
    Worst worst;
    for (int i = 0; i < 300000; ++i) {
        const T x = T(i % 2 == 0 ? random.log_uniform(1e-6, 60) : random.uniform(0, 1));
        worst.add(compare_ulp("one_minus_exp", {{"x", x}}, one_minus_exp(x),
                              -std::expm1(-static_cast<long double>(x))));
    }
    worst.print("against expm1");
    CHECK_WORST(worst, 3.0L);  // the docstring's bound
}

TEST_CASE_TEMPLATE("safe_sqrt is the square root, and 0 for what rounding pushed below", T, float, double,
                   long double) {
    CHECK(safe_sqrt(T(9)) == T(3));  // exact: square roots of squares are
    CHECK(safe_sqrt(T(0)) == T(0));
    CHECK(safe_sqrt(T(-1e-30L)) == T(0));
    CHECK(safe_sqrt(-std::numeric_limits<T>::max()) == T(0));
    Random random(12);
    for (int i = 0; i < 1000; ++i) {
        const T x = T(random.log_uniform(1e-30, 1e30));
        CHECK_EQUAL(compare_ulp("safe_sqrt", {{"x", x}}, safe_sqrt(x), std::sqrt(x)));  // the same operation
        // Exact: 1024^2 and 1024 are powers of two.
        CHECK_EQUAL(compare_ulp("safe_sqrt", {{"x", x}}, safe_sqrt(T(1048576) * x), T(1024) * safe_sqrt(x)));
    }
}

TEST_CASE_TEMPLATE("x cross y is z; parallel and opposite vectors have none", T, float, double, long double) {
    const vec3<T> x = vec3<T>(T(1), T(0), T(0));
    const vec3<T> y = vec3<T>(T(0), T(1), T(0));
    CHECK(cross_of_unit_vectors(x, y) == vec3<T>(T(0), T(0), T(1)));  // exact: zeros and ones
    CHECK(cross_of_unit_vectors(y, x) == vec3<T>(T(0), T(0), T(-1)));
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const vec3<T> a = random.direction<T>();
        CHECK(cross_of_unit_vectors(a, a) == vec3<T>(T(0)));  // exact: a - a is 0
        CHECK(cross_of_unit_vectors(a, -a) == vec3<T>(T(0)));
        const vec3<T> b = random.direction<T>();
        const vec3<T> across = cross_of_unit_vectors(a, b);
        // At right angles to both: each of the three products may be off by the docstring's 4 roundoffs of
        // the length and the dot product rounds three times more; the square is free of the root's rounding.
        const long double length = std::sqrt(static_cast<long double>(glm::dot(across, across)));
        CHECK(std::fabs(static_cast<long double>(glm::dot(across, a))) <= 8 * unit_roundoff<T>() * length);
        CHECK(std::fabs(static_cast<long double>(glm::dot(across, b))) <= 8 * unit_roundoff<T>() * length);
        // sin^2 + cos^2 = 1, for vectors whose own length is off by up to 3 roundoffs.
        const T cosine = glm::dot(a, b);
        CHECK_WITHIN(
            compare_ulp("sin^2 + cos^2", {}, glm::dot(across, across) + cosine * cosine, 1.0L),
            sizeof(T) == sizeof(long double) ? 1e5L : 16.0L);  // the sampler's directions are doubles
    }
}

TEST_CASE_TEMPLATE("dot_product of a 3-4-12 box's diagonal with itself is 169", T, float, double,
                   long double) {
    const vec3<T> diagonal = vec3<T>(T(3), T(4), T(12));
    CHECK(airlight::dot_product(diagonal, diagonal) == T(169));                  // exact: small integers
    CHECK(airlight::dot_product(diagonal, vec3<T>(T(4), T(-3), T(0))) == T(0));  // at right angles
}

TEST_CASE_TEMPLATE("dot_product adds from x to z", T, float, double, long double) {
    // A 1 beside 4 / u is lost, so the order of the sums decides what is left.
    const T big = T(1) / unit_roundoff<T>();
    const vec3<T> ones = vec3<T>(T(1), T(1), T(1));
    CHECK(airlight::dot_product(vec3<T>(big, -big, T(1)), ones) == T(1));  // (big - big) + 1
    CHECK(airlight::dot_product(vec3<T>(T(1), T(4) * big, T(-4) * big), ones) ==
          T(0));  // (1 + 4 big) - 4 big
}

TEST_CASE_TEMPLATE("cross_of_unit_vectors agrees with 50 digits, nearly parallel vectors included", T, float,
                   double, long double) {
    Worst worst;
    Worst textbook;
    for (const Row& row : reference("cross")) {
        const vec3<T> a = vec3<T>(row.input<T>("ax"), row.input<T>("ay"), row.input<T>("az"));
        const vec3<T> b = vec3<T>(row.input<T>("bx"), row.input<T>("by"), row.input<T>("bz"));
        const long double expected[] = {row.expected("x"), row.expected("y"), row.expected("z")};
        const long double length =
            std::sqrt(expected[0] * expected[0] + expected[1] * expected[1] + expected[2] * expected[2]);
        const vec3<T> got = cross_of_unit_vectors(a, b);
        const vec3<T> plain = glm::cross(a, b);
        for (int i = 0; i < 3; ++i) {
            worst.add(compare_roundoffs(
                "cross_of_unit_vectors",
                {{"ax", a.x}, {"ay", a.y}, {"az", a.z}, {"bx", b.x}, {"by", b.y}, {"bz", b.z}}, got[i],
                expected[i], length));
            textbook.add(
                compare_roundoffs("glm::cross", {{"ax", a.x}, {"bx", b.x}}, plain[i], expected[i], length));
        }
    }
    worst.print("against 50 digits");
    textbook.print("against 50 digits, for comparison");
    CHECK_WORST(worst, 2.0L);  // the docstring's bound, in roundoffs of the result's length
}

TEST_SUITE_END();
