#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/froxel_table.hpp>

#include <cmath>

#include "extremes.hpp"
#include "promises.hpp"
#include "samplers.hpp"
#include "story.hpp"

using namespace airlight;
using namespace airlight_test;

TEST_SUITE_BEGIN("froxel_table");

TEST_CASE_TEMPLATE("the middle of the screen is straight ahead, its edges a half width aside", T, float,
                   double) {
    const CameraRays<T> camera = {vec3<T>(T(1), T(0), T(0)), vec3<T>(T(0), T(-1), T(0)),
                                  vec3<T>(T(0), T(0), T(0.5))};
    CHECK(camera_direction(camera, vec2<T>(T(0.5), T(0.5))) == vec3<T>(T(1), T(0), T(0)));
    const vec3<T> right = camera_direction(camera, vec2<T>(T(1), T(0.5)));
    CHECK(right.x == doctest::Approx(std::sqrt(0.5)));
    CHECK(right.y == doctest::Approx(-std::sqrt(0.5)));
    CHECK(camera_direction(camera, vec2<T>(T(0.5), T(1))).z > T(0));
}

TEST_CASE_TEMPLATE("a ray that clears the ground stays, one that does not is lifted until it does", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const Viewpoint<T> eye{T(100), vec3<T>(T(0), T(0), T(1))};
    const vec3<T> up(T(0.6L), T(0), T(0.8L));
    CHECK(direction_above_ground(air, eye, up, T(1e5L)) == up);
    Random random(81);
    int lifted_rays = 0;
    for (int i = 0; i < 2000; ++i) {
        const T mu = T(-random.log_uniform(1e-4, 0.9));
        const T azimuth = T(random.uniform(0, 6.28));
        const T sine = std::sqrt((T(1) - mu) * (T(1) + mu));
        const vec3<T> direction(sine * std::cos(azimuth), sine * std::sin(azimuth), mu);
        const T distance = T(random.log_uniform(1, 1e5));
        const vec3<T> lifted = direction_above_ground(air, eye, direction, distance);
        const ViewPath<T> path = view_path(air, eye, lifted, distance);
        lifted_rays += lifted != direction ? 1 : 0;
        INFO("mu ", double(mu), " distance ", double(distance));
        // It gets as far as the slice: to rounding, which at the horizon is a fraction of the way.
        CHECK(path.end >= distance * T(0.97L));
        CHECK(std::fabs(dot_product(lifted, lifted) - 1) <= T(8) * std::numeric_limits<T>::epsilon());
        // Over the same place: no turn about the vertical.
        CHECK(std::fabs(lifted.x * direction.y - lifted.y * direction.x) <=
              T(8) * std::numeric_limits<T>::epsilon());
        CHECK(lifted.z >= direction.z);
    }
    CHECK(lifted_rays > 300);
    const vec3<T> down(T(0), T(0), T(-1));
    CHECK(direction_above_ground(air, eye, down, T(1e4L)) == down);  // no side to be lifted to
}

TEST_CASE_TEMPLATE("the depth of what passes", T, float, double) {
    CHECK(depth_of_transmittance(vec3<T>(T(1))) == vec3<T>(T(0)));  // exact: log(1)
    CHECK(depth_of_transmittance(vec3<T>(T(0))).x == doctest::Approx(69.0775527898));
    CHECK(depth_of_transmittance(vec3<T>(std::exp(T(-2)))).y == doctest::Approx(2));
}

/// Froxels of even air: light and depth in closed form, along slices.
template <typename T>
struct EvenAir {
    T max_distance;
    int slices;
    T depth_per_length;
    int depth;

    FroxelAir<T> operator()(const vec3<T>& uvw) const {
        const FroxelPoint<T> at = froxel_parameters(uvw, max_distance, slices, 8, 8, depth);
        const T x = depth_per_length * at.distance;
        return FroxelAir<T>{vec3<T>(T(1) - std::exp(-x)), vec3<T>(x)};
    }
};

TEST_CASE_TEMPLATE("in even air the look-up is exact between slices, however few and thick they are", T,
                   float, double) {
    Random random(82);
    Worst light;
    Worst passed;
    for (int i = 0; i < 3000; ++i) {
        const int slices = i % 2 == 0 ? slices_linear : slices_quadratic;
        const int depth = 2 + random.below(30);
        const T per_length = T(random.log_uniform(1e-7, 1e-3));
        const T max_distance = T(5e4L);
        const T distance = T(random.uniform(0, 5e4));
        const EvenAir<T> air = {max_distance, slices, per_length, depth};
        const Scattered<T> got =
            froxel_light(vec2<T>(T(0.3L), T(0.6L)), distance, max_distance, slices, 8, 8, depth, air);
        const long double x = static_cast<long double>(per_length) * distance;
        light.add(compare_roundoffs("froxel_light", {{"x", T(x)}}, got.radiance.y, -std::expm1(-x), 1.0L));
        passed.add(
            compare_roundoffs("froxel_light", {{"x", T(x)}}, got.transmittance.y, std::exp(-x), 1.0L + x));
    }
    // mean_passed's 2e-6, and roundoffs of the distances, which the depth of a slice multiplies.
    const long double series = 2e-6L / (static_cast<long double>(std::numeric_limits<T>::epsilon()) / 2);
    CHECK_WORST(light, 256.0L + 2 * series);
    CHECK_WORST(passed, 256.0L);
}

TEST_CASE_TEMPLATE("the camera itself sees no air, beyond the last slice it is that of the last", T, float,
                   double) {
    const EvenAir<T> air = {T(1e4L), slices_linear, T(1e-4L), 4};
    const auto at = [&](T distance) {
        return froxel_light(vec2<T>(T(0.5), T(0.5)), distance, T(1e4L), slices_linear, 8, 8, 4, air);
    };
    CHECK(at(T(0)).radiance == vec3<T>(T(0)));  // exact: the first slice
    CHECK(at(T(0)).transmittance == vec3<T>(T(1)));
    CHECK(at(T(1e4L)).radiance == at(T(1e9L)).radiance);
    CHECK(at(no_surface<T>()).transmittance == at(T(1e4L)).transmittance);
    const Scattered<T> without =
        froxel_light(vec2<T>(T(0.5), T(0.5)), T(10), T(1e4L), slices_linear, 8, 8, 4);
    CHECK(without.radiance == vec3<T>(T(0)));
    CHECK(without.transmittance == vec3<T>(T(1)));
}

TEST_CASE_TEMPLATE("every atmosphere, eye and slice gives amounts of light and depth", T, float, double) {
    Random random(83);
    for (int i = 0; i < 3000; ++i) {
        const Atmosphere<T> air = any_atmosphere<T>(random);
        const Viewpoint<T> eye = any_viewpoint<T>(random, air);
        const vec3<T> direction = random.below(5) == 0 ? -eye.up : random.direction<T>();
        const vec3<T> to_sun = random.direction<T>();
        const T distance = T(zero_or_between(random, 1e-3, 1e12));
        const FroxelAir<T> texel = froxel_texel<T>(air, eye, direction, to_sun, distance);
        INFO("altitude ", double(eye.altitude), " distance ", double(distance), " R ",
             double(air.ground_radius));
        CHECK_UNARY(is_amount(texel.radiance));
        CHECK_UNARY(is_amount(texel.depth));
    }
}

TEST_SUITE_END();
