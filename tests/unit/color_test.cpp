#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/color.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("color");

TEST_CASE_TEMPLATE("white has luminance 1, and green most of it", T, float, double, long double) {
    CHECK_WITHIN(compare_ulp("luminance", {}, luminance(vec3<T>(T(1))), 1.0L),
                 3.0L);  // three weights, two sums round
    CHECK(luminance(vec3<T>(T(0))) == T(0));
    CHECK(luminance(vec3<T>(T(0), T(1), T(0))) == T(0.7152L));  // exact: a weight times 1
}

TEST_CASE_TEMPLATE("a quarter, a half: exposure 1 - exp(-k x) by hand", T, float, double, long double) {
    const T ln2 = T(0.693147180559945309417232121458176568L);
    const vec3<T> got = exposed(vec3<T>(ln2, 2 * ln2, T(0)), T(1));
    CHECK_WITHIN(compare_ulp("exposed", {{"x", ln2}}, got.x, 0.5L), 4.0L);  // one_minus_exp and ln 2 rounded
    CHECK_WITHIN(compare_ulp("exposed", {{"x", 2 * ln2}}, got.y, 0.75L), 4.0L);
    CHECK(got.z == T(0));
}

TEST_CASE_TEMPLATE("exposure is linear in the dark, never above 1, and grows with light", T, float, double,
                   long double) {
    const T faint = std::numeric_limits<T>::epsilon() / 8;
    CHECK_WITHIN(compare_ulp("exposed", {{"x", faint}}, exposed(vec3<T>(faint), T(4)).x,
                             4.0L * static_cast<long double>(faint)),
                 3.0L);
    CHECK(exposed(vec3<T>(std::numeric_limits<T>::max()), T(1)) == vec3<T>(T(1)));  // exact: exp underflows
    Random random(61);
    for (int i = 0; i < 2000; ++i) {
        const T x = T(random.log_uniform(1e-6, 1e3));
        const T y = exposed(vec3<T>(x), T(2)).y;
        CHECK_UNARY(y >= T(0) && y <= T(1));
        CHECK_UNARY(exposed(vec3<T>(x * T(1.01L)), T(2)).y >= y);
        // Radiance in another unit with the exposure to match: the same product. Exact: a power of two.
        CHECK(exposed(vec3<T>(x * T(1024)), T(2) / T(1024)) == exposed(vec3<T>(x), T(2)));
    }
}

TEST_CASE_TEMPLATE("sRGB: black, white and middle grey", T, float, double, long double) {
    CHECK(srgb_from_linear(vec3<T>(T(0))) == vec3<T>(T(0)));  // exact: the linear part
    // 1.055 - 0.055: both constants and the difference are rounded.
    CHECK_WITHIN(compare_ulp("srgb_from_linear", {{"linear", 1}}, srgb_from_linear(vec3<T>(T(1))).x, 1.0L),
                 2.0L);
    CHECK_WITHIN(compare_ulp("linear_from_srgb", {{"encoded", 1}}, linear_from_srgb(vec3<T>(T(1))).x, 1.0L),
                 2.0L);
    // 18 % grey is code value 118 of 255 (117.6, rounded to a whole code).
    CHECK(std::lround(srgb_from_linear(vec3<T>(T(0.18L))).x * 255) == 118);
    // Each channel goes its own way.
    const vec3<T> mixed = srgb_from_linear(vec3<T>(T(0), T(0.18L), T(1)));
    CHECK(mixed.x == T(0));
    CHECK(mixed.y == srgb_from_linear(vec3<T>(T(0.18L))).x);
    CHECK(mixed.z == srgb_from_linear(vec3<T>(T(1))).x);
}

TEST_CASE_TEMPLATE("every 8-bit code value survives decoding and encoding", T, float, double, long double) {
    for (int code = 0; code < 256; ++code) {
        const T encoded = T(code) / T(255);
        const T back = srgb_from_linear(linear_from_srgb(vec3<T>(encoded))).x;
        CHECK(std::lround(back * 255) == code);
        // Powers 2.4 and 1 / 2.4, both constants and results rounded: 8 ulp; at the seam of the two pieces
        // the standard's constants meet only to 1e-7 or so: that is its modelling error, not ours.
        const long double seam = 2e-7L;
        CHECK(std::fabs(static_cast<long double>(back) - static_cast<long double>(encoded)) <=
              8 * ulp_spacing<T>(encoded) + (code == 10 || code == 11 ? seam : 0.0L));
    }
}

TEST_CASE_TEMPLATE("the curve is increasing, through its seam too", T, float, double, long double) {
    T previous_code = T(-1);
    T previous_light = T(-1);
    for (int i = 0; i <= 4096; ++i) {
        const T x = T(i) / T(4096);
        const T code = srgb_from_linear(vec3<T>(x)).x;
        const T light = linear_from_srgb(vec3<T>(x)).x;
        CHECK_UNARY(code > previous_code);
        CHECK_UNARY(light > previous_light);
        previous_code = code;
        previous_light = light;
    }
}

TEST_CASE_TEMPLATE("colours agree with 50 digits", T, float, double, long double) {
    Worst encode;
    Worst decode;
    Worst light;
    for (const Row& row : reference("color")) {
        const std::string& name = row.text("function");
        const T a = row.input<T>("a");
        const T b = row.input<T>("b");
        const T c = row.input<T>("c");
        const long double expected = row.expected("expected");
        if (name == "srgb_from_linear") {
            encode.add(
                compare_ulp("srgb_from_linear", {{"linear", a}}, srgb_from_linear(vec3<T>(a)).x, expected));
        } else if (name == "linear_from_srgb") {
            decode.add(
                compare_ulp("linear_from_srgb", {{"encoded", a}}, linear_from_srgb(vec3<T>(a)).x, expected));
        } else {
            REQUIRE(name == "luminance");
            light.add(compare_ulp("luminance", {{"red", a}, {"green", b}, {"blue", c}},
                                  luminance(vec3<T>(a, b, c)), expected));
        }
    }
    encode.print("against 50 digits");
    decode.print("against 50 digits");
    light.print("against 50 digits");
    // The difference 1.055 x^(1/2.4) - 0.055 amplifies by up to 2.4 at the seam; power, exponent, product
    // round.
    CHECK_WORST(encode, 6.0L + table_rounding<T>());
    // Sum and quotient are amplified by the power 2.4; the exponent's own rounding by ln(x) up to 3.
    CHECK_WORST(decode, 8.0L + table_rounding<T>());
    CHECK_WORST(light, 3.0L + table_rounding<T>());  // the docstring's bound
}

TEST_CASE_TEMPLATE("values outside 0 to 1 are clamped", T, float, double, long double) {
    CHECK(srgb_from_linear(vec3<T>(T(-1), T(2), T(1e30L))) ==
          srgb_from_linear(vec3<T>(T(0), T(1), T(1))));  // exact: the same arguments after clamping
    CHECK(linear_from_srgb(vec3<T>(T(-1), T(2), T(1e30L))) == linear_from_srgb(vec3<T>(T(0), T(1), T(1))));
}

TEST_SUITE_END();
