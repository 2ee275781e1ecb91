#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <airlight/habitat_mapping.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// The document's, in kilometres.
template <typename T>
HabitatAir<T> air() {
    return HabitatAir<T>{T(8), T(0.00736L), vec3<T>(T(0)), vec3<T>(T(0)), vec3<T>(T(0)), T(0)};
}

template <typename T>
HabitatLights<T> lights() {
    return HabitatLights<T>{T(24), T(5), T(16), T(0.1L), vec3<T>(T(1)), T(0.2L), T(2) / T(24)};
}

/// The document's own formula for x > 0, in kilometres, of the doubles it is printed with.
double printed_warp(double x) {
    const double a = 0.2;
    const double big = 2.0;
    const double b[] = {(5 - big) / (5 - a), big / a, (16 - 5 - 2 * big) / (16 - 5 - 2 * a), big / a};
    const double c[] = {0, 5 * (1 - big / a), 5 + big - (5 + a) * b[2], 16 * (1 - big / a)};
    const double bp = (24 - 16 - big) / (24 - 16 - a);
    const double cp = 24 * (big - a) / (24 - 16 - a);
    double y[4];
    for (int i = 0; i < 4; ++i) {
        y[i] = x * b[i] + c[i];
    }
    const auto clamp = [](double v, double low, double high) { return std::min(std::max(v, low), high); };
    return clamp(y[3], clamp(y[1], y[0], y[2]), x * bp + cp);
}

}  // namespace

TEST_SUITE_BEGIN("habitat_mapping");

TEST_CASE_TEMPLATE("places along a half lie where the document has them", T, float, double) {
    for (int i = 0; i <= 480; ++i) {
        const double x = 0.05 * i;
        CAPTURE(x);
        // Float's roundoffs of 24.
        CHECK(double(T(24) * share_of_half(lights<T>(), T(x))) ==
              doctest::Approx(printed_warp(x)).epsilon(1e-5));
    }
}

TEST_CASE_TEMPLATE("the strips lie on the wall, three a half, and shine to the axis", T, float, double) {
    for (int i = 0; i < 6; ++i) {
        const LinearLight<T> light = habitat_strip(air<T>(), lights<T>(), i);
        CHECK(double(light.centre.x) == doctest::Approx(i < 3 ? 10.5 : -10.5));
        CHECK(double(std::hypot(light.centre.y, light.centre.z)) == doctest::Approx(8));
        CHECK(double(light.half_length) == doctest::Approx(5.5));
        CHECK(double(glm::length(light.normal)) == doctest::Approx(1));
        CHECK(double(glm::dot(light.centre + T(8) * light.normal - vec3<T>(light.centre.x, T(0), T(0)),
                              vec3<T>(T(0), T(1), T(1)))) == doctest::Approx(0).scale(1e-5));  // float's of 8
        CHECK(double(unit_from_habitat(air<T>(), lights<T>(), light.centre).z) ==
              doctest::Approx(0).scale(2e-3).epsilon(1));  // the root of a roundoff
    }
}

TEST_CASE_TEMPLATE("a place of coordinates has these coordinates", T, float, double) {
    Random random(630);
    for (int i = 0; i < 20000; ++i) {
        const double x = random.uniform(0, 1);
        const double y = random.uniform(0, 0.999);
        const double z = random.uniform(0, 1);
        const vec3<T> unit(i % 16 == 0 ? T(i % 32 / 16) : T(x), i % 11 == 0 ? T(0) : T(y),
                           i % 13 == 0 ? T(i % 26 / 13) : T(z));
        const vec3<T> place = habitat_from_unit(air<T>(), lights<T>(), unit);
        const vec3<T> back = unit_from_habitat(air<T>(), lights<T>(), place);
        CAPTURE(exact((long double)unit.x));
        CAPTURE(exact((long double)unit.y));
        CAPTURE(exact((long double)unit.z));
        const double roundoff = double(std::numeric_limits<T>::epsilon());
        CHECK(std::fabs(double(back.x - unit.x)) <=
              16 * roundoff * 12);  // the steepest stretch is 12 times as coarse
        // What rounding leaves of a difference to the radius, and to a strip's angle, under the root; near
        // the axis the angle is that of little.
        CHECK(std::fabs(double(back.y * back.y - unit.y * unit.y)) <=
              8 * roundoff + 1e-12);  // the series of the sine
        CHECK(std::fabs(double(back.z * back.z - unit.z * unit.z)) <=
              32 * roundoff + 6e-8);  // the arc tangent's fit
    }
}

TEST_CASE_TEMPLATE("the six parts of the cylinder are alike", T, float, double) {
    Random random(631);
    for (int i = 0; i < 2000; ++i) {
        const double angle = random.uniform(0, 1.047);
        const double r = random.uniform(0.1, 8);
        const double x = random.uniform(-24, 24);
        const auto at = [&](double turned) {
            return unit_from_habitat(air<T>(), lights<T>(),
                                     vec3<T>(T(x), T(r * std::cos(turned)), T(r * std::sin(turned))));
        };
        const vec3<T> first = at(angle);
        for (const double other :
             {-angle, angle + 2.0943951023932, 2.0943951023932 - angle, angle - 2.0943951023932}) {
            // Squares: the root makes a roundoff near the strip large.
            CHECK(double(at(other).z * at(other).z) ==
                  doctest::Approx(double(first.z * first.z)).epsilon(1e-5).scale(1));
        }
    }
}

TEST_SUITE_END();
