#include <doctest/doctest.h>
#include <airlight/constants.hpp>
#include <airlight/sky_view_mapping.hpp>

#include "mapping_round_trip.hpp"
#include "samplers.hpp"

using namespace airlight;
using namespace airlight_test;

TEST_SUITE_BEGIN("sky_view_mapping");

TEST_CASE_TEMPLATE("the sky has the zenith at the top, the nadir at the bottom, the horizon on both sides", T,
                   float, double) {
    const T R = T(6.36e6);
    const auto v = [&](T mu, bool ground) { return sky_view_uv(R, T(0), mu, T(1), ground, 192, 108).y; };
    const T rounding = std::numeric_limits<T>::epsilon();              // of the sum with a half
    CHECK(std::fabs(v(T(1), false) - T(0.5) / T(108)) <= rounding);    // the first texel
    CHECK(std::fabs(v(T(0), false) - T(53.5L) / T(108)) <= rounding);  // the two that meet in the middle
    CHECK(std::fabs(v(T(0), true) - T(54.5L) / T(108)) <= rounding);
    CHECK(std::fabs(v(T(-1), true) - T(107.5L) / T(108)) <= rounding);  // the last one
    const auto u = [&](T c) { return sky_view_uv(R, T(0), T(0.5), c, false, 192, 108).x; };
    CHECK(u(T(1)) == T(0.5) / T(192));  // exact: towards the sun
    CHECK(u(T(-1)) == T(191.5L) / T(192));
}

TEST_CASE_TEMPLATE(
    "texels are as close in angle at the horizon as those of the source, and even at the zenith", T, float,
    double) {
    // At 60 degrees from the zenith the source has sqrt(1 - 2/3) = 0.577, this sqrt(1 - sin 30 / sin 45).
    const T y = sky_view_uv(T(6.36e6), T(0), T(0.5), T(1), false, 192, 108).y;
    const long double ours = std::sqrt(1.0L - 0.5L / std::sqrt(0.5L));
    CHECK_WITHIN(compare_ulp("sky_view_uv.y", {}, y, 0.5L - (0.5L + ours * 53) / 108), 16.0L);
    // Over all heights the two part by at most 0.0371 of their half of the table, at 67 degrees: by hand.
    const auto source = [](double z) { return std::sqrt(1 - z / (0.5 * pi<double>)); };
    double apart = 0;
    for (double z = 0; z <= 0.5 * pi<double>; z += 1e-3) {
        const double row =
            double(sky_view_uv(T(6.36e6), T(0), T(std::cos(z)), T(1), false, 192, 108).y) * 108 - 0.5;
        apart = std::fmax(apart, std::fabs(source(z) - (1 - row / 53)));
    }
    MESSAGE("rows apart from the source's, share of a half: " << apart);
    CHECK(apart <= 0.038);  // in docs/decisions/0014
    CHECK(apart >= 0.036);
    // Twice the angle from the zenith is twice as many rows, to the curvature of the sine.
    const auto rows = [&](double angle) {
        return 0.5 -
               54.0 *
                   (1.0 -
                    2.0 * double(sky_view_uv(T(6.36e6), T(0), T(std::cos(angle)), T(1), false, 192, 108).y));
    };
    const double zenith = rows(0.0);
    CHECK((rows(0.08) - zenith) / (rows(0.04) - zenith) == doctest::Approx(2.0).epsilon(0.05));
}

TEST_CASE_TEMPLATE("every texel of sky and froxels comes back to its own centre", T, float, double) {
    RoundTrip sky, froxels;
    for (const TableWorld& world : table_worlds()) {
        const T R = T(world.air.ground_radius);
        for (const double altitude : {0.0, 2e-9, 1e-6, 1e-3, 0.5, 1.0, 3.0}) {
            const T h = T(altitude * world.air.top_altitude);
            for_each_centre<T>(192, 108, 1, [&](const vec3<T>& centre) {
                const vec2<T> uv(centre.x, centre.y);
                const SkyDirection<T> at = sky_view_parameters(R, h, uv, 192, 108);
                const vec2<T> back = sky_view_uv(R, h, at.mu, at.azimuth_cosine, at.reaches_ground, 192, 108);
                sky.add(world.name, uv.x, back.x, 192);
                sky.add(world.name, uv.y, back.y, 108);
            });
        }
    }
    for (const int slices : {slices_linear, slices_quadratic}) {
        for_each_centre<T>(32, 16, 32, [&](const vec3<T>& centre) {
            const FroxelPoint<T> at = froxel_parameters(centre, T(128000), slices, 32, 16, 32);
            const vec3<T> back = froxel_uvw(at.screen, at.distance, T(128000), slices, 32, 16, 32);
            froxels.add("froxels", centre.x, back.x, 32);
            froxels.add("froxels", centre.y, back.y, 16);
            froxels.add("froxels", centre.z, back.z, 32);
        });
    }
    sky.print("sky view");
    froxels.print("froxels");
    const double roundoff = static_cast<double>(unit_roundoff<T>());
    CHECK_MESSAGE(sky.worst() <= 108 * std::sqrt(8 * roundoff), sky.story());  // the root of some roundoffs
    CHECK_MESSAGE(froxels.worst() <= 8 * 32 * roundoff, froxels.story());      // 8 roundoffs of the size
}

TEST_CASE_TEMPLATE("froxels begin at the camera and end at their largest distance", T, float, double) {
    const vec2<T> middle(T(0.5), T(0.5));
    for (const int slices : {slices_linear, slices_quadratic}) {
        CHECK(froxel_uvw(middle, T(0), T(1000), slices, 16, 16, 32).z == T(0.5) / T(32));  // exact
        CHECK(froxel_uvw(middle, T(1000), T(1000), slices, 16, 16, 32).z == T(31.5L) / T(32));
        CHECK(froxel_uvw(middle, no_surface<T>(), T(1000), slices, 16, 16, 32).z == T(31.5L) / T(32));
    }
    // A quarter of the way is half of the slices, or a quarter of them.
    CHECK(froxel_uvw(middle, T(250), T(1000), slices_quadratic, 16, 16, 32).z == T(0.5));
    CHECK(froxel_uvw(middle, T(250), T(1000), slices_linear, 16, 16, 33).z == T(8.5L) / T(33));
}

TEST_CASE_TEMPLATE("a direction has the cosines it was made from", T, float, double) {
    Random random(5);
    Worst heights, azimuths, lengths;
    for (int i = 0; i < 4000; ++i) {
        const vec3<T> up = random.direction<T>();
        const vec3<T> to_sun = random.direction<T>();
        const T mu = T(random.uniform(-0.999, 0.999));
        const T azimuth = T(random.uniform(-1.0, 1.0));
        const vec3<T> direction = sky_direction(up, to_sun, mu, azimuth);
        const long double sun_sine = std::sqrt(1.0L - static_cast<long double>(dot_product(up, to_sun)) *
                                                          static_cast<long double>(dot_product(up, to_sun)));
        const long double sine = std::sqrt(1.0L - static_cast<long double>(mu) * mu);
        heights.add(compare_roundoffs("sky_direction", {{"mu", mu}}, dot_product(up, direction), mu, 1.0L));
        azimuths.add(compare_roundoffs("sun_azimuth_cosine", {{"azimuth", azimuth}, {"mu", mu}},
                                       sun_azimuth_cosine(up, direction, to_sun), azimuth,
                                       1.0L / sine + 1.0L / sun_sine));
        lengths.add(
            compare_roundoffs("sky_direction.length", {}, dot_product(direction, direction), 1.0L, 1.0L));
    }
    heights.print("height");
    azimuths.print("azimuth");
    CHECK_WORST(heights, 16.0L);   // three products of three factors
    CHECK_WORST(azimuths, 16.0L);  // the condition is one over the sines of both
    CHECK_WORST(lengths, 16.0L);
}

TEST_CASE_TEMPLATE("a vertical sun or view has an azimuth too", T, float, double) {
    for (const vec3<T>& up :
         {vec3<T>(T(0), T(0), T(1)), vec3<T>(T(1), T(0), T(0)), vec3<T>(T(0), T(-1), T(0))}) {
        CHECK(sun_azimuth_cosine(up, up, vec3<T>(T(0.6L), T(0), T(0.8L))) == T(1));
        CHECK(sun_azimuth_cosine(up, vec3<T>(T(0.6L), T(0), T(0.8L)), -up) == T(1));
        const vec3<T> level = sky_direction(up, up, T(0), T(1));
        CHECK(dot_product(level, level) == T(1));  // exact: an axis
        CHECK(dot_product(level, up) == T(0));
    }
}

TEST_CASE_TEMPLATE("whatever sky and froxels are given, they stay on the table", T, float, double) {
    std::vector<T> numbers = odd_numbers<T>();
#ifndef __FAST_MATH__
    for (const T none : no_numbers<T>()) {
        numbers.push_back(none);
    }
#endif
    const auto share = [](T x) { return x >= T(0) && x <= T(1); };
    for (const T a : numbers) {
        for (const T b : numbers) {
            for (const T c : numbers) {
                CAPTURE(a);
                CAPTURE(b);
                CAPTURE(c);
                const vec2<T> uv = sky_view_uv(T(6.36e6), a, b, c, c < T(0), 4, 6);
                CHECK(share(uv.x));
                CHECK(share(uv.y));
                const SkyDirection<T> at = sky_view_parameters(T(6.36e6), a, vec2<T>(b, c), 4, 6);
                CHECK(share(std::fabs(at.mu)));
                CHECK(share(std::fabs(at.azimuth_cosine)));
                for (const int slices : {slices_linear, slices_quadratic}) {
                    const vec3<T> uvw = froxel_uvw(vec2<T>(a, b), c, T(1000), slices, 4, 4, 1);
                    CHECK(share(uvw.x));
                    CHECK(share(uvw.y));
                    CHECK(share(uvw.z));
                    const FroxelPoint<T> point =
                        froxel_parameters(vec3<T>(a, b, c), T(1000), slices, 4, 4, 4);
                    CHECK(share(point.screen.x));
                    CHECK(share(point.distance / T(1000)));
                }
            }
        }
    }
}

TEST_SUITE_END();
