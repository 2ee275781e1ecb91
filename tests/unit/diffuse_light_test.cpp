#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/constants.hpp>
#include <airlight/diffuse_light.hpp>
#include <airlight/phase.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// The moments of two beams of irradiance 2 pi each, mirrored in the sun's plane: their definition.
DiffuseLight<double> two_beams(const vec3<double>& from, double sun_sine) {
    const double x = from.x;
    const double y = from.y;
    const double z = from.z;
    const vec3<double> one(1.0);
    const vec3<double> none(0.0);
    return DiffuseLight<double>{one,
                                one * (1.5 * z * z - 0.5),
                                one * (x * z / sun_sine),
                                one * ((x * x - y * y) / (sun_sine * sun_sine)),
                                none,
                                none,
                                none,
                                none,
                                none};
}

}  // namespace

TEST_SUITE_BEGIN("diffuse_light");

TEST_CASE_TEMPLATE("even light is scattered evenly: coefficients times radiance", T, float, double,
                   long double) {
    Random random(71);
    const vec3<T> radiance(T(0.5), T(1), T(2));
    const vec3<T> rayleigh(T(0.25), T(0.5), T(1));
    const vec3<T> mie(T(2), T(0.5), T(0));
    for (int i = 0; i < 1000; ++i) {
        const vec3<T> d = random.direction<T>();
        const vec3<T> sun = random.direction<T>();
        const vec3<T> got = scattered_diffuse_light(even_light(radiance), rayleigh, mie, d.z,
                                                    d.x * sun.x + d.y * sun.y + d.z * sun.z, sun.z);
        for (int c = 0; c < 3; ++c) {
            const long double expected = static_cast<long double>((rayleigh[c] + mie[c]) * radiance[c]);
            // The weights of aerosol's five sides add up to 1 within smallest_lean and a dozen roundings.
            CHECK(std::fabs(static_cast<long double>(got[c]) - expected) <=
                  16 * ulp_spacing<T>(expected) + 1e-6L * 2);
        }
    }
}

TEST_CASE("molecules scatter two beams exactly as Rayleigh's phase function says") {
    Random random(72);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double mu_s = 1.98 * random.unit() - 0.99;
        const double sun_sine = std::sqrt((1 - mu_s) * (1 + mu_s));
        const vec3<double> from = random.direction<double>();
        const vec3<double> d = random.direction<double>();
        const double cos_theta = d.x * sun_sine + d.z * mu_s;
        const vec3<double> got = scattered_diffuse_light(two_beams(from, sun_sine), vec3<double>(1.0),
                                                         vec3<double>(0.0), d.z, cos_theta, mu_s);
        const double level = d.x * from.x + d.z * from.z;
        const double expected =
            2 * pi<double> * (rayleigh_phase(level + d.y * from.y) + rayleigh_phase(level - d.y * from.y));
        worst = std::max(worst, std::fabs(got.x - expected));
    }
    CHECK(worst <= 1e-13);  // a dozen roundings of numbers near 1, over the sun's squared sine of 0.02
}

TEST_CASE("aerosol's light towards the five sides is the light that was kept") {
    const vec3<double> none(0.0);
    const vec3<double> one(1.0);
    for (const double mu_s : {-0.1, 0.0, 0.5, 0.9}) {
        const double s = std::sqrt((1 - mu_s) * (1 + mu_s));
        const DiffuseLight<double> light{none,      none,      none,      none,     one,
                                         2.0 * one, 3.0 * one, 4.0 * one, 5.0 * one};
        const auto towards = [&](double x, double z) {
            return scattered_diffuse_light(light, none, one, z, x * s + z * mu_s, mu_s).x;
        };
        // smallest_lean over the sun's squared sine.
        const double blur = 1e-5;
        CHECK(towards(0, 1) == doctest::Approx(1).epsilon(blur));
        CHECK(towards(0, -1) == doctest::Approx(2).epsilon(blur));
        CHECK(towards(1, 0) == doctest::Approx(3).epsilon(blur));
        CHECK(towards(-1, 0) == doctest::Approx(4).epsilon(blur));
        CHECK(towards(0, 0) == doctest::Approx(5).epsilon(blur));  // y = 1
    }
}

TEST_CASE_TEMPLATE("scattered light is finite and never negative, whatever the moments", T, float, double) {
    Random random(73);
    for (int i = 0; i < 20000; ++i) {
        const auto any = [&](double low, double high) {
            return vec3<T>(T(low + (high - low) * random.unit()), T(low + (high - low) * random.unit()),
                           T(0));
        };
        const DiffuseLight<T> light{any(0, 1), any(-9, 9), any(-9, 9), any(-9, 9), any(0, 1),
                                    any(0, 1), any(0, 1),  any(0, 1),  any(0, 1)};
        const vec3<T> d = i % 3 == 0 ? vec3<T>(T(0), T(0), i % 2 == 0 ? T(1) : T(-1)) : random.direction<T>();
        const vec3<T> sun = i % 5 == 0 ? vec3<T>(T(0), T(0), T(1)) : random.direction<T>();
        const vec3<T> got = scattered_diffuse_light(light, vec3<T>(T(1)), vec3<T>(T(1)), d.z,
                                                    d.x * sun.x + d.y * sun.y + d.z * sun.z, sun.z);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(exact(d.z));
            CAPTURE(exact(sun.z));
            CHECK(std::isfinite(static_cast<double>(got[c])));
            CHECK(got[c] >= T(0));
        }
    }
}

TEST_SUITE_END();
