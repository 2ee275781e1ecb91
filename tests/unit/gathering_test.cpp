#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/gathering.hpp>

#include "story.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("gathering");

TEST_CASE_TEMPLATE("the directions cover the sphere and know the moments of light", T, float, double,
                   long double) {
    for (const T altitude : {T(0), T(2000), T(9e4L)}) {
        T sphere = T(0);
        T up = T(0);
        T square = T(0);
        T beside = T(0);
        for (int side = 0; side < 2; ++side) {
            for (int polar = 0; polar < 8; ++polar) {
                for (int azimuth = 0; azimuth < 16; ++azimuth) {
                    const SphereDirection<T> d =
                        sphere_direction<T>(T(6360e3), altitude, side, polar, azimuth);
                    sphere += T(2) * d.solid_angle;
                    up += T(2) * d.solid_angle * d.mu;
                    square += T(2) * d.solid_angle * d.mu * d.mu;
                    beside += T(2) * d.solid_angle * d.sine * d.cos_azimuth;
                    CHECK(std::fabs(d.mu * d.mu + d.sine * d.sine - T(1)) <= T(8) * unit_roundoff<T>());
                    CHECK(std::fabs(d.cos_azimuth * d.cos_azimuth + d.sin_azimuth * d.sin_azimuth - T(1)) <=
                          T(8) * unit_roundoff<T>());
                    CHECK(d.sin_azimuth > T(0));
                }
            }
        }
        const long double slack = 256.0L * unit_roundoff<T>();  // 256 terms are added
        CHECK(std::fabs(static_cast<long double>(sphere) - 4 * pi<long double>) <=
              4 * pi<long double> * slack);
        CHECK(std::fabs(static_cast<long double>(up)) <= 2 * pi<long double> * slack);
        CHECK(std::fabs(static_cast<long double>(square) - 4 * pi<long double> / 3) <= 4 * slack);
        CHECK(std::fabs(static_cast<long double>(beside)) <= 4 * pi<long double> * slack);
    }
}

TEST_CASE_TEMPLATE("the sun on level ground counts as its cosine, and from below not at all", T, float,
                   double, long double) {
    const Atmosphere<T> bare = airless(earth<T>());
    CHECK(direct_irradiance<T>(bare, T(0), T(0.25L)) == vec3<T>(T(0.25L)));  // exact: times exp(0)
    CHECK(direct_irradiance<T>(bare, T(0), T(-0.25L)) == vec3<T>(T(0)));
    // Exact: the same call.
    CHECK(direct_irradiance<T>(earth<T>(), T(2), T(0.5L)) ==
          T(0.5L) * transmittance_to_space<T>(earth<T>(), T(2), T(0.5L)));
}

TEST_SUITE_END();
