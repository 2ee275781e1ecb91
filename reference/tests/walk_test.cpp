#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "reference/views.hpp"

using namespace reference;

namespace {

/// How many standard errors two estimates are apart.
double apart(const Estimate& a, const Estimate& b) {
    return std::fabs(a.mean - b.mean) / std::hypot(a.error, b.error);
}

}  // namespace

TEST_CASE("furnace: in even light, over white ground, air that absorbs nothing cannot be seen") {
    airlight::Atmosphere<double> white = airlight::earth<double>();
    white.mie_absorption = white.ozone_absorption = Vector(0.0);
    white.ground_albedo = Vector(1.0);
    Light light;
    light.sun = 0;
    light.sky = 1;
    for (const int channel : {0, 2}) {
        const Air air(white, airlight::ozone_none, channel);
        for (const double altitude : {2.0, 1e4}) {
            for (const double elevation : {90.0, 1.0, -30.0}) {
                const ViewRay ray =
                    view_ray(air, Vector(0, 0, air.ground_radius() + altitude), direction_at(elevation));
                const Radiance got = traced(air, light, ray, Effort{20000, 11, 20});
                const double expected = 1 - air.along(ray.begin, ray.direction, ray.extent);
                std::printf("furnace, channel %d, %.0f m, view %.0f: %.6f +- %.1e for %.6f\n", channel,
                            altitude, elevation, got.total.mean, got.total.error, expected);
                // Three standard errors, and what the cells of the first meeting are off where nothing
                // varies.
                CHECK(std::fabs(got.total.mean - expected) <= 3 * got.total.error + 1e-6 * expected);
                CHECK(got.total.error <=
                      1e-4 * expected);  // hardly anything is left to chance: this can fail
            }
        }
    }
}

TEST_CASE("reciprocity: as much light reaches the ground forwards as is found backwards") {
    airlight::Atmosphere<double> bright = airlight::earth<double>();
    bright.ground_albedo = Vector(0.3);
    for (const int channel : {0, 2}) {
        const Air air(bright, airlight::ozone_tent, channel);
        const Estimate forwards = absorbed_by_ground(air, Effort{200000, 21, 20});
        const Estimate backwards = absorbed_by_ground_backwards(air, Effort{100000, 22, 20});
        std::printf("absorbed by the ground, channel %d: %.4f +- %.4f forwards, %.4f +- %.4f backwards\n",
                    channel, forwards.mean, forwards.error, backwards.mean, backwards.error);
        CHECK(apart(forwards, backwards) < 3);
        CHECK(forwards.error < 0.01);
        CHECK(backwards.error < 0.01);
        // Without air it would be 1 - albedo; air turns light away and absorbs some.
        CHECK(forwards.mean < 0.7);
        CHECK(forwards.mean > 0.4);
    }
}

TEST_CASE("the same seed gives the same numbers, another seed others that agree") {
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 2);
    const View view{2, 20, 30, 90};
    const Radiance a = traced(air, view, 0, Effort{20000, 1, 20});
    const Radiance b = traced(air, view, 0, Effort{20000, 1, 20});
    const Radiance c = traced(air, view, 0, Effort{20000, 2, 20});
    CHECK(a.total.mean == b.total.mean);  // exact: the same walks
    CHECK(a.total.error == b.total.error);
    CHECK(a.total.mean != c.total.mean);
    CHECK(apart(a.total, c.total) < 4);  // once in 15000 pairs of seeds
}

TEST_CASE("the orders add up, and four times the walks halve the error") {
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 1);
    const View view{2, 60, 90, 0};
    const Radiance few = traced(air, view, 0, Effort{10000, 1, 50});
    const Radiance many = traced(air, view, 0, Effort{160000, 1, 50});
    double sum = 0;
    for (const Estimate& order : many.order) {
        CHECK(order.mean >= 0);
        sum += order.mean;
    }
    CHECK(std::fabs(sum - many.total.mean) <= 1e-12 * many.total.mean);  // rounding of 1e5 terms
    // Sixteen times the walks, a quarter of the error: each is known to 10 %.
    CHECK(few.total.error / many.total.error > 2.5);
    CHECK(few.total.error / many.total.error < 6);
}

TEST_CASE("nothing is seen without air, without light, and of ground behind it") {
    airlight::Atmosphere<double> vacuum = airlight::earth<double>();
    vacuum.rayleigh_scattering = vacuum.mie_scattering = vacuum.mie_absorption = vacuum.ozone_absorption =
        Vector(0.0);
    const View view{2, 20, -30, 0};
    CHECK(traced(Air(vacuum, airlight::ozone_tent, 0), view, 0, Effort{1000, 1, 10}).total.mean == 0);
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 0);
    const View past_the_air{1e6, 20, 90, 0};
    CHECK(traced(air, past_the_air, 0, Effort{1000, 1, 10}).total.mean == 0);
    Light none;
    none.sun = 0;
    const ViewRay ray = view_ray(air, Vector(0, 0, air.ground_radius() + 2), direction_at(45));
    CHECK(traced(air, none, ray, Effort{1000, 1, 10}).total.mean == 0);
    // At midnight all that light could do is go round the planet.
    CHECK(traced(air, View{2, -90, 90, 0}, 0, Effort{1000, 1, 10}).total.mean == 0);
}

TEST_CASE("light adds up: sun and sky together are the sun's and the sky's, in twilight too") {
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 0);
    const ViewRay ray = view_ray(air, Vector(0, 0, air.ground_radius() + 2), direction_at(20));
    for (const double sun_elevation : {30.0, -4.0}) {
        Light sun;
        sun.to_sun = direction_at(sun_elevation);
        Light sky = sun;
        sky.sun = 0;
        sky.sky = 1e-2;
        Light both = sky;
        both.sun = 1;
        const Estimate a = traced(air, sun, ray, Effort{40000, 1, 40}).total;
        const Estimate b = traced(air, sky, ray, Effort{40000, 2, 40}).total;
        const Estimate c = traced(air, both, ray, Effort{40000, 3, 40}).total;
        CHECK(apart(c, Estimate{a.mean + b.mean, std::hypot(a.error, b.error)}) < 4);  // once in 15000
        CHECK(b.mean > 5 * c.error);  // the sky's share is large enough to be missed
    }
}

TEST_CASE("a small sun gives the light of a point, a wide one spreads the lobe") {
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 1);
    const View beside{2, 30, 30, 40};
    const Radiance point = traced(air, beside, 0, Effort{40000, 1, 20});
    const Radiance disc = traced(air, beside, 0.53, Effort{40000, 2, 20});
    CHECK(apart(point.total, disc.total) < 4);  // once in 15000
    CHECK(std::fabs(disc.order[0].mean / point.order[0].mean - 1) <
          1e-3);  // curvature of the lobe over 0.5 degrees
    const View into{2, 30, 30, 0};
    CHECK(traced(air, into, 20, Effort{40000, 1, 20}).order[0].mean <
          0.9 * traced(air, into, 0, Effort{40000, 1, 20}).order[0].mean);
}
