#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/ray_legs.hpp>

#include "extremes.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "views.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
LitRay<T> ray_at(const Atmosphere<T>& air, T altitude, double mu, T distance) {
    const Viewpoint<T> eye{altitude, vec3<T>(T(0), T(0), T(1))};
    const vec3<T> direction(T(std::sqrt((1 - mu) * (1 + mu))), T(0), T(mu));
    return lit_ray<T>(air, air_ray(air, eye, direction, distance), eye, direction, eye.up);
}

}  // namespace

TEST_SUITE_BEGIN("ray_legs");

TEST_CASE_TEMPLATE("a ray that climbs or falls has one leg, one that passes its closest approach two", T,
                   float, double) {
    const Atmosphere<T> air = earth<T>();
    const T horizon = std::sqrt(T(2) * air.ground_radius * T(5000));
    const RayLegs<T> up = ray_legs<T>(air, ray_at(air, T(5000), 0.5, no_surface<T>()));
    CHECK(up.turn == T(0));
    CHECK(up.start.altitude == up.turned.altitude);
    CHECK(up.last.altitude > T(99e3));
    const LitRay<T> falling = ray_at(air, T(5000), -0.5, T(1000));
    const RayLegs<T> down = ray_legs<T>(air, falling);
    CHECK(down.turn == falling.air.extent);
    CHECK(down.last.altitude == down.turned.altitude);
    CHECK(down.start.altitude > down.turned.altitude);
    const RayLegs<T> both = ray_legs<T>(air, ray_at(air, T(5000), -0.01, no_surface<T>()));
    CHECK(both.turn > T(0));
    CHECK(both.turn < horizon);
    CHECK(both.turned.altitude < both.start.altitude);
    CHECK(both.turned.altitude < both.last.altitude);
}

TEST_CASE_TEMPLATE("the legs' depth is the ray's optical depth", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    for (const double mu : {1.0, 0.3, 0.0, -0.02, -0.039, -0.3, -1.0}) {
        for (const double distance : {3e3, 3e4, 1e7}) {
            const LitRay<T> ray = ray_at(air, T(5000), mu, T(distance));
            const vec3<T> got = depth_of_legs<T>(air, ray_legs<T>(air, ray));
            const vec3<T> expected = optical_depth<T>(air, T(5000), T(mu), ray.air.extent);
            for (int c = 0; c < 3; ++c) {
                CAPTURE(mu);
                CAPTURE(distance);
                // The same closed forms, summed another way: Chapman's function is good to some 1e-7 of
                // columns of depth 4, and their difference keeps a few roundoffs of float.
                CHECK(std::fabs(static_cast<double>(got[c] - expected[c])) <= 4e-6);
            }
        }
    }
}

TEST_CASE_TEMPLATE("what the nodes found becomes what there was to find", T, float, double) {
    // 1 - exp(-2) = 0.8646647167633873...
    CHECK_WITHIN(compare_ulp("loss_ratio", {}, loss_ratio(T(0.5L), T(7), T(2)), 1.729329433526774616212L),
                 4.0L);  // one_minus_exp's own 3 and a division
    // A ray too thin for a difference of columns: the nodes' depth counts, however wrong the other is.
    CHECK_WITHIN(
        compare_ulp("loss_ratio", {}, loss_ratio(T(1e-6L), T(1e-6L), T(3e-5L)), 0.99999950000016666662L),
        8.0L);                                            // the inputs round, too
    CHECK(loss_ratio(T(1e-9L), T(50), T(0)) <= T(1e6L));  // and no more than thin_depth of it
    CHECK(loss_ratio(T(0), T(0), T(0)) == T(1));
    const vec3<T> three =
        loss_ratios(vec3<T>(T(0.5L), T(0), T(1)), vec3<T>(T(2), T(0), T(3)), vec3<T>(T(2), T(0), T(3)));
    CHECK(three.x == loss_ratio(T(0.5L), T(2), T(2)));
    CHECK(three.y == T(1));
    CHECK(three.z == loss_ratio(T(1), T(3), T(3)));
}

TEST_CASE_TEMPLATE("for any air and ray the legs are in it and their depth is a depth", T, float, double) {
    Random random(77);
    int rays = 0;
    for (int i = 0; i < 20000; ++i) {
        const Atmosphere<T> air = any_atmosphere<T>(random);
        const Viewpoint<T> eye = any_viewpoint(random, air);
        const vec3<T> direction = any_direction(random, air, eye);
        const AirRay<T> inside = air_ray(air, eye, direction, any_distance<T>(random));
        if (inside.in_air) {
            ++rays;
            const LitRay<T> ray =
                lit_ray<T>(air, inside, eye, direction, any_sun(random, air, eye, direction));
            const RayLegs<T> legs = ray_legs<T>(air, ray);
            const vec3<T> depth = depth_of_legs<T>(air, legs);
            CAPTURE(i);
            CHECK(legs.turn >= T(0));
            CHECK(legs.turn <= inside.extent);
            for (int c = 0; c < 3; ++c) {
                CHECK(depth[c] >= T(0));  // false for NaN
            }
        }
    }
    CHECK(rays > 5000);
}

TEST_SUITE_END();
