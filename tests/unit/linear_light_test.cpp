#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/linear_light.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// In z = 0 along x, shining upwards.
template <typename T>
LinearLight<T> strip(T half_length, T width) {
    return LinearLight<T>{
        vec3<T>(T(0)), vec3<T>(T(1), T(0), T(0)), vec3<T>(T(0), T(0), T(1)), half_length, width,
        vec3<T>(T(1))};
}

template <typename T>
vec3<T> unit(const Row& row) {
    return glm::normalize(vec3<T>(row.input<T>("nx"), row.input<T>("ny"), row.input<T>("nz")));
}

}  // namespace

TEST_SUITE_BEGIN("linear_light");

TEST_CASE_TEMPLATE("over an endless strip, 1 width high, the solid angle is 4 atan(1/2)", T, float, double,
                   long double) {
    const LinearLight<T> light = strip<T>(T(1e4L), T(1));
    const double got = double(strip_view(light, vec3<T>(T(0), T(0), T(1))).solid_angle);
    CHECK(got ==
          doctest::Approx(4 * std::atan(0.5)).epsilon(1e-6));  // ends: (1 / 1e4)^2 and float's roundoffs
}

TEST_CASE_TEMPLATE("an endless strip far above lights level ground with pi w L / (2 h)", T, float, double) {
    const LinearLight<T> light{vec3<T>(T(0), T(0), T(100)),
                               vec3<T>(T(1), T(0), T(0)),
                               vec3<T>(T(0), T(0), T(-1)),
                               T(1e6L),
                               T(0.1L),
                               vec3<T>(T(3))};
    const vec3<T> e = strip_irradiance(light, vec3<T>(T(0)), vec3<T>(T(0), T(0), T(1)));
    CHECK(double(e.x) == doctest::Approx(3 * 3.14159265 / 2 * 0.1 / 100).epsilon(1e-5));  // ends: (1e-4)^3
    CHECK(strip_irradiance(light, vec3<T>(T(0)), vec3<T>(T(0), T(0), T(-1))).x == T(0));  // from behind
}

TEST_CASE_TEMPLATE("the solid angle falls to both sides and grows with the strip", T, float, double) {
    T before = T(10);
    for (int i = 0; i <= 100; ++i) {
        const T got = strip_view(strip<T>(T(50), T(1)), vec3<T>(T(2 * i), T(3), T(5))).solid_angle;
        CHECK(got < before);
        CHECK(got > T(0));
        before = got;
    }
    before = T(0);
    for (int i = 1; i <= 100; ++i) {
        const T got = strip_view(strip<T>(T(i), T(1)), vec3<T>(T(200), T(3), T(5))).solid_angle;
        CHECK(got > before);
        before = got;
    }
}

TEST_CASE_TEMPLATE("the points of a strip lie on it, in order, and halve its solid angle", T, float, double) {
    Random random(610);
    for (int i = 0; i < 5000; ++i) {
        const double half_length = random.log_uniform(1, 1e4);
        const double width = random.log_uniform(1e-3, 1);
        const double x = random.uniform(-3, 3) * half_length;
        const double y = random.log_uniform(0.1, 1e4) * (i % 2 == 0 ? 1 : -1);
        const double z = random.log_uniform(0.1, 1e4);
        const LinearLight<T> light = strip<T>(T(half_length), T(width));
        const vec3<T> position = vec3<T>(T(x), T(y), T(z));
        const StripView<T> view = strip_view(light, position);
        CAPTURE(half_length);
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(z);
        double before = double(view.begin);
        const double reach = std::fabs(x) + std::fabs(y) + z + half_length;
        for (const T share : {T(0.05L), T(0.5L), T(0.95L)}) {
            const vec3<T> at = position + strip_point(view, share);
            // Roundoffs of the way there and back.
            const double tolerance = 1e-6 * reach;
            CHECK(std::fabs(double(at.z)) <= tolerance);
            CHECK(std::fabs(double(at.y)) <= tolerance);
            const double u = double(glm::dot(at - position, view.along));
            CHECK(u >= before - tolerance);
            CHECK(u <= double(view.end) + tolerance);
            before = u;
        }
        // The two halves at the point of a half are as large as each other.
        const T half = glm::dot(strip_point(view, T(0.5L)), view.along);
        const StripView<T> there = strip_view(light, position);
        const double d = double(there.distance);
        const auto sine = [d](double u) { return u / std::hypot(u, d); };
        const double whole = double(view.span);
        const double first = sine(double(half)) - sine(double(view.begin));
        // The test's own subtraction leaves a roundoff of 1 beside the span.
        CHECK(std::fabs(first - 0.5 * whole) <= 1e-5 * whole + 2e-7);
    }
}

TEST_CASE("solid angle and irradiance are those of the rectangle that the strip is") {
    for (const std::string kind : {"far", "middle", "near"}) {
        std::vector<double> solid;
        std::vector<double> lit;
        std::vector<double> in_float;
        for (const Row& row : reference("linear_light")) {
            if (row.text("kind") != kind) {
                continue;
            }
            const auto view_of = [&row](auto t) {
                using T = decltype(t);
                return strip_view(strip(row.input<T>("half_length"), row.input<T>("width")),
                                  vec3<T>(row.input<T>("x"), row.input<T>("y"), row.input<T>("z")));
            };
            const auto irradiance_of = [&row](auto t) {
                using T = decltype(t);
                return strip_irradiance(strip(row.input<T>("half_length"), row.input<T>("width")),
                                        vec3<T>(row.input<T>("x"), row.input<T>("y"), row.input<T>("z")),
                                        unit<T>(row))
                    .x;
            };
            const double exact_angle = double(row.expected("solid_angle"));
            const double angle = view_of(0.0).solid_angle;
            solid.push_back(std::fabs(angle / exact_angle - 1));
            in_float.push_back(std::fabs(double(view_of(0.0F).solid_angle) / angle - 1));
            // Of what the solid angle could give at most: where the surface sees the strip edgewise nothing
            // is left.
            lit.push_back(std::fabs(irradiance_of(0.0) - double(row.expected("irradiance"))) / exact_angle);
        }
        std::printf(
            "strip, %s: solid angle p50 %.2g p95 %.2g worst %.2g; irradiance over solid angle p95 %.2g worst "
            "%.2g; "
            "float p95 %.2g worst %.2g\n",
            kind.c_str(), percentile(solid, 0.5), percentile(solid, 0.95), percentile(solid, 1),
            percentile(lit, 0.95), percentile(lit, 1), percentile(in_float, 0.95), percentile(in_float, 1));
        const bool far = kind == "far";
        const bool middle = kind == "middle";
        CHECK(percentile(solid, 1) <= 2e-4);  // modelling: (width / distance)^2 / 8 at 32 widths
        // Modelling: the middle of the strip's width stands for all of it, but not within 4 widths.
        CHECK(percentile(lit, 1) <= (far ? 2e-4 : middle ? 2e-3 : 6e-4));
        CHECK(percentile(in_float, 1) <= (far      ? 1e-5
                                          : middle ? 5e-5
                                                   : 1e-2));  // near: roundoffs over the span
    }
}

TEST_CASE_TEMPLATE("absurd strips and places give finite light", T, float, double) {
    Random random(611);
    const T sizes[] = {T(0), T(1e-6L), T(1), T(1e4L), T(1e9L)};
    for (const T half_length : sizes) {
        for (const T width : sizes) {
            for (const T away : sizes) {
                for (const T aside : sizes) {
                    const LinearLight<T> light = strip<T>(half_length, width);
                    for (const T high : {T(0), T(1e-6L), T(1), T(1e9L), T(-1)}) {
                        const vec3<T> position(away, aside, high);
                        const StripView<T> view = strip_view(light, position);
                        const T solid = view.solid_angle;
                        CHECK(solid >= T(0));  // and no NaN
                        CHECK(solid <= T(6.2832L));
                        for (const T share : {T(1e-6L), T(0.5L), T(0.999999L)}) {
                            const vec3<T> at = strip_point(view, share);
                            CHECK(std::isfinite(at.x + at.y + at.z));
                        }
                        const vec3<T> normal = vec3<T>(random.direction<T>());
                        const T lit = strip_irradiance(light, position, normal).x;
                        CHECK(lit >= T(0));
                        CHECK(lit <= T(3.1416L));
                    }
                }
            }
        }
    }
}

TEST_SUITE_END();
