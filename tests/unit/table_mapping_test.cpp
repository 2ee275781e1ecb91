#include <doctest/doctest.h>
#include <airlight/table_mapping.hpp>

#include "mapping_round_trip.hpp"
#include "samplers.hpp"

using namespace airlight;
using namespace airlight_test;

TEST_SUITE_BEGIN("table_mapping");

TEST_CASE_TEMPLATE("the ends of [0, 1] are the centres of the first and last texel", T, float, double) {
    CHECK(texture_from_unit(T(0), 4) == T(0.125));  // exact: binary fractions
    CHECK(texture_from_unit(T(1), 4) == T(0.875));
    CHECK(texture_from_unit(T(0.5), 4) == T(0.5));
    CHECK(unit_from_texture(T(0.125), 4) == T(0));
    CHECK(unit_from_texture(T(0.875), 4) == T(1));
    CHECK(unit_from_texture(T(0), 4) == T(0));  // beyond the centre of the first texel
    CHECK(unit_from_texture(T(1), 4) == T(1));  // beyond that of the last
    CHECK(texture_from_unit(T(2), 4) == T(0.875));
    CHECK(texture_from_unit(T(-3), 4) == T(0.125));
    CHECK(texture_from_unit(T(0.7L), 1) == T(0.5));  // a single texel is everywhere the same
    CHECK(unit_from_texture(T(0.7L), 1) == T(0));
}

TEST_CASE_TEMPLATE("every size gives back every unit", T, float, double) {
    Random random(7);
    for (const int size : {2, 3, 8, 33, 256, 4096}) {
        for (int i = 0; i < 1000; ++i) {
            const T x = T(random.unit());
            const T back = unit_from_texture(texture_from_unit(x, size), size);
            // 2 roundoffs of a coordinate in [0, 1], which the inverse multiplies by size / (size - 1).
            CHECK(std::fabs(back - x) <= T(8) * std::numeric_limits<T>::epsilon());
        }
    }
}

TEST_CASE_TEMPLATE("an extinction table has altitude along x and the angle along y, 0 up and 1 down", T,
                   float, double) {
    // A source's text has the altitude along x and the angle along y, its code the other way round, and its
    // direction is neither an angle nor a cosine. Here the axes of the text, and the cosine.
    const Atmosphere<T> air = earth<T>();
    const vec2<T> ground_up = extinction_uv(air, T(0), T(1), 256, 64);
    CHECK(ground_up.x == T(0.5) / T(256));  // exact: the first texel's centre
    CHECK(ground_up.y == T(0.5) / T(64));
    const vec2<T> top_down = extinction_uv(air, air.top_altitude, T(-1), 256, 64);
    CHECK(top_down.x == T(255.5L) / T(256));  // exact: 511 / 512
    CHECK(top_down.y == T(63.5L) / T(64));
    // Half way: the horizontal direction at half of the height.
    const vec2<T> middle = extinction_uv(air, T(0.5) * air.top_altitude, T(0), 256, 64);
    CHECK(middle.x == T(0.5));  // exact: halves
    CHECK(middle.y == T(0.5));
}

TEST_CASE_TEMPLATE(
    "an extinction table is even in the cosine: a quarter of the way down is 60 degrees, not 45", T, float,
    double) {
    // In a source the direction of the table is neither angle nor cosine. A quarter of the way down a table
    // even in the angle has 45 degrees, and so has the direction (1 - |a|, a) at a = 1/2.
    const Atmosphere<T> air = earth<T>();
    const vec2<T> quarter = extinction_uv(air, T(0), T(0.5), 65, 65);
    CHECK(quarter.y == T(16.5L) / T(65));  // exact: 1/2 + 64 / 4, and one quotient on both sides
    const T mu = extinction_parameters(air, quarter, 65, 65).mu;
    CHECK(std::fabs(mu - T(0.5)) <=
          T(4 * 65) * std::numeric_limits<T>::epsilon());  // 4 roundoffs of the size
    CHECK(std::fabs(mu - std::sqrt(T(0.5))) > T(0.2L));
}

TEST_CASE_TEMPLATE("below the ground every table is read at the ground", T, float, double) {
    // A source disagrees with itself: one function clamps an altitude at the ground, another takes its
    // absolute value.
    const Atmosphere<T> air = earth<T>();
    for (const T depth : {T(1), T(1e3), T(6.36e6), T(1e9)}) {
        for (const T mu : {T(-1), T(-0.3L), T(0), T(0.2L), T(1)}) {
            CHECK(extinction_uv(air, -depth, mu, 32, 32) == extinction_uv(air, T(0), mu, 32, 32));
            CHECK(transmittance_uv(air, -depth, mu, 32, 32) == transmittance_uv(air, T(0), mu, 32, 32));
            CHECK(altitude_sun_uv(air, -depth, mu, 32, 32) == altitude_sun_uv(air, T(0), mu, 32, 32));
        }
    }
}

TEST_CASE_TEMPLATE("the horizon of a point on the ground is level, and 1.4 altitudes away from a small world",
                   T, float, double) {
    CHECK(horizon_cosine(T(6.36e6), T(0)) == T(0));
    // R = 3, h = 2: the tangent is 4 long, its angle at the eye has the cosine 4 / 5.
    CHECK(horizon_distance(T(3), T(2)) == T(4));  // exact: integers
    CHECK(horizon_cosine(T(3), T(2)) == T(-0.8L));
    CHECK(altitude_of_horizon(T(3), T(4)) == T(2));
}

TEST_CASE_TEMPLATE(
    "below the horizon of a small world lies a fifth of a cosine, and nearly none from far away", T, float,
    double, long double) {
    CHECK(cosines_below_horizon(T(3), T(2), T(-0.8L)) == doctest::Approx(0.2).epsilon(1e-6));  // 1 - 4 / 5
    CHECK(cosines_below_horizon(T(1), T(0), T(0)) == T(1));  // exact: on the ground half of all directions
    // From a million radii 1 + horizon_cosine would be 0 in float; (R / r)^2 / 2 is left.
    const T far = T(1e6L);
    CHECK_WITHIN(
        compare_ulp("cosines_below_horizon", {}, cosines_below_horizon(T(1), far, horizon_cosine(T(1), far)),
                    0.5L / ((1 + 1e6L) * (1 + 1e6L))),
        8.0L + 2.5e-13L / unit_roundoff<T>());  // modelling: the next term of the series
}

TEST_CASE_TEMPLATE("the sun over x is a unit vector, for cosines that rounding pushed too far too", T, float,
                   double, long double) {
    CHECK(sun_over_x(T(0)) == vec3<T>(T(1), T(0), T(0)));  // exact: roots of 1 and 0
    CHECK(sun_over_x(T(1)) == vec3<T>(T(0), T(0), T(1)));
    CHECK(sun_over_x(T(-1.25L)) == vec3<T>(T(0), T(0), T(-1)));
    const vec3<T> sun = sun_over_x(T(-0.6L));
    CHECK_WITHIN(compare_ulp("sun_over_x.x", {}, sun.x, 0.8L), 4.0L);
    CHECK(sun.z == T(-0.6L));
}

TEST_CASE_TEMPLATE("two halves of an axis never share a texel", T, float, double) {
    CHECK(texture_from_halves(T(0), true, 8) == T(4.5L) / T(8));  // exact: binary fractions
    CHECK(texture_from_halves(T(1), true, 8) == T(7.5L) / T(8));
    CHECK(texture_from_halves(T(0), false, 8) == T(3.5L) / T(8));
    CHECK(texture_from_halves(T(1), false, 8) == T(0.5L) / T(8));
    CHECK(unit_from_halves(T(7.5L) / T(8), 8) == T(1));
    CHECK(unit_from_halves(T(0.5L) / T(8), 8) == T(1));
    CHECK(unit_from_halves(T(0.5), 8) == T(0));
}

TEST_CASE_TEMPLATE("a bent sun's axis is densest at the horizon, goes from -1 to 1, and comes back", T, float,
                   double, long double) {
    const T bend = T(0.225L);
    CHECK(bent_sun(T(-1), bend) == T(-1));  // exact: a number over itself
    CHECK(bent_sun(T(0), bend) == T(0));
    CHECK(bent_sun(T(1), bend) == T(1));
    // Slopes over 1/1024 at the horizon and at the zenith.
    const T step = T(1) / T(1024);
    const T at_horizon = bent_sun(step, bend) - bent_sun(T(0), bend);
    const T at_zenith = bent_sun(T(1), bend) - bent_sun(T(1) - step, bend);
    CHECK(at_horizon / at_zenith > T(28));  // (1 + 1 / 0.225)^2 = 29.6, less 1 % for the step
    CHECK(at_horizon / at_zenith < T(30));
    for (int i = -64; i <= 64; ++i) {
        const T mu_s = T(i) / T(64);
        // 4 roundoffs there, that times (1 + bend) / bend and 4 more back.
        CHECK(std::fabs(sun_from_bent(bent_sun(mu_s, bend), bend) - mu_s) <= T(32) * unit_roundoff<T>());
    }
    CHECK(sun_from_bent(T(1), bend) == T(1));
    CHECK(sun_from_bent(T(-1), bend) == T(-1));
}

TEST_CASE_TEMPLATE("the excess of a ray is its length to the top less the vertical one", T, float, double) {
    // R = 3, h = 0, top = 2: level the ray is 4 long, upward 2, downward 8.
    CHECK(excess_to_top(T(3), T(2), T(0), T(1)) == T(0));  // exact: 1 - mu = 0
    CHECK_WITHIN(compare_ulp("excess_to_top", {}, excess_to_top(T(3), T(2), T(0), T(0)), 2.0L), 8.0L);
    CHECK_WITHIN(compare_ulp("excess_to_top", {}, excess_to_top(T(3), T(2), T(0), T(-1)), 6.0L), 8.0L);
    CHECK_WITHIN(
        compare_ulp("cosine_from_excess", {}, T(1) + cosine_from_excess(T(3), T(2), T(0), T(2)), 1.0L), 8.0L);
    CHECK_WITHIN(compare_ulp("cosine_from_excess", {}, cosine_from_excess(T(3), T(2), T(0), T(6)), -1.0L),
                 8.0L);
}

TEST_CASE_TEMPLATE("the excess of a ray agrees with its textbook form in long double", T, float, double) {
    Worst worst;
    Random random(11);
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        for (int i = 0; i < 3000; ++i) {
            const T h = T(random.unit()) * air.top_altitude;
            const T mu =
                T(random.below(2) == 0 ? random.uniform(-1.0, 1.0) : 1.0 - random.log_uniform(1e-7, 1.0));
            const long double r = static_cast<long double>(air.ground_radius) + h;
            const long double t = static_cast<long double>(air.ground_radius) + air.top_altitude;
            const long double along = r * mu;
            const long double s = std::sqrt(along * along + (t - r) * (t + r));
            const long double length = along > 0 ? (t - r) * (t + r) / (along + s) : s - along;
            worst.add(compare_roundoffs(
                "excess_to_top", {{"altitude", h}, {"mu", mu}},
                excess_to_top(air.ground_radius, air.top_altitude, h, mu), length - (t - r),
                // the textbook form itself loses these digits in long double
                std::fabs(length - (t - r)) +
                    length * std::numeric_limits<long double>::epsilon() / unit_roundoff<T>() * 4));
        }
    }
    worst.print("over worlds");
    CHECK_WORST(worst, 12.0L);  // a product of seven factors and two square roots
}

TEST_CASE_TEMPLATE("every texel of a two-dimensional table comes back to its own centre", T, float, double) {
    RoundTrip extinction, transmittance, sun;
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        const int width = 256;
        const int height = 64;
        for_each_centre<T>(width, height, 1, [&](const vec3<T>& centre) {
            const vec2<T> uv(centre.x, centre.y);
            const AltitudeCosine<T> e = extinction_parameters(air, uv, width, height);
            const vec2<T> e_back = extinction_uv(air, e.altitude, e.mu, width, height);
            extinction.add(world.name, uv.x, e_back.x, width);
            extinction.add(world.name, uv.y, e_back.y, height);
            const AltitudeCosine<T> t = transmittance_parameters(air, uv, width, height);
            const vec2<T> t_back = transmittance_uv(air, t.altitude, t.mu, width, height);
            transmittance.add(world.name, uv.x, t_back.x, width);
            transmittance.add(world.name, uv.y, t_back.y, height);
            const AltitudeCosine<T> s = altitude_sun_parameters(air, uv, width, height);
            const vec2<T> s_back = altitude_sun_uv(air, s.altitude, s.mu, width, height);
            sun.add(world.name, uv.x, s_back.x, width);
            sun.add(world.name, uv.y, s_back.y, height);
        });
    }
    extinction.print("extinction");
    transmittance.print("transmittance");
    sun.print("altitude and sun");
    const double roundoff = static_cast<double>(unit_roundoff<T>());
    CHECK_MESSAGE(extinction.worst() <= 4 * 256 * roundoff, extinction.story());  // 4 roundoffs of the width
    CHECK_MESSAGE(sun.worst() <= 4 * 256 * roundoff, sun.story());
    // 30 roundoffs there and 30 back, of the width.
    CHECK_MESSAGE(transmittance.worst() <= 60 * 256 * roundoff, transmittance.story());
}

TEST_CASE_TEMPLATE("no texel of a table of transmittances looks below the horizon", T, float, double) {
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        for_each_centre<T>(64, 32, 1, [&](const vec3<T>& centre) {
            const AltitudeCosine<T> at = transmittance_parameters(air, vec2<T>(centre.x, centre.y), 64, 32);
            CHECK(at.mu >= horizon_cosine(air.ground_radius, at.altitude));
            CHECK(at.altitude >= T(0));
            CHECK(at.altitude <= air.top_altitude);
        });
    }
}

TEST_CASE_TEMPLATE("coordinates grow with altitude and with the angle", T, float, double) {
    // Up to roundoff: a neighbour may step back by as much as a coordinate is rounded.
    const T slack = T(64) * std::numeric_limits<T>::epsilon();
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        for (int i = 0; i <= 20; ++i) {
            const T h = air.top_altitude * T(i) / T(20);
            const T above = air.top_altitude * T(i + 1) / T(20);
            vec2<T> before(T(-1), T(-1));
            for (int j = 0; j <= 200; ++j) {
                const T mu = T(1) - T(j) / T(100);
                const vec2<T> uv = transmittance_uv(air, h, mu, 256, 64);
                CHECK(uv.x >= before.x - slack);
                CHECK(transmittance_uv(air, above, mu, 256, 64).y >= uv.y);
                CHECK(extinction_uv(air, above, mu, 256, 64).x >= extinction_uv(air, h, mu, 256, 64).x);
                CHECK(altitude_sun_uv(air, above, mu, 256, 64).y >= altitude_sun_uv(air, h, mu, 256, 64).y);
                before = uv;
            }
        }
    }
}

TEST_CASE_TEMPLATE("lengths in another unit give the same coordinates", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const Atmosphere<T> scaled = rescaled(air, T(1024));  // a power of two: scaling rounds nothing
    for (const T h : {T(0), T(1), T(1234), T(50000), T(100000)}) {
        for (const T mu : {T(-0.1L), T(0), T(0.01L), T(0.7L), T(1)}) {
            CHECK(transmittance_uv(scaled, T(1024) * h, mu, 256, 64) ==
                  transmittance_uv(air, h, mu, 256, 64));
            CHECK(extinction_uv(scaled, T(1024) * h, mu, 256, 64) == extinction_uv(air, h, mu, 256, 64));
            CHECK(altitude_sun_uv(scaled, T(1024) * h, mu, 256, 64) == altitude_sun_uv(air, h, mu, 256, 64));
        }
    }
}

TEST_CASE_TEMPLATE("whatever a two-dimensional mapping is given, it stays on the table", T, float, double) {
    std::vector<T> numbers = odd_numbers<T>();
#ifndef __FAST_MATH__
    for (const T none : no_numbers<T>()) {
        numbers.push_back(none);
    }
#endif
    const auto on_table = [](const vec2<T>& uv) {
        return uv.x >= T(0) && uv.x <= T(1) && uv.y >= T(0) && uv.y <= T(1);
    };
    for (const TableWorld& world : all_table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        for (const T a : numbers) {
            for (const T b : numbers) {
                for (const int size : {1, 2, 7}) {
                    CAPTURE(a);
                    CAPTURE(b);
                    CHECK(on_table(extinction_uv(air, a, b, size, 3)));
                    CHECK(on_table(transmittance_uv(air, a, b, size, 3)));
                    CHECK(on_table(altitude_sun_uv(air, a, b, size, 3)));
                    for (const AltitudeCosine<T>& at :
                         {extinction_parameters(air, vec2<T>(a, b), size, 3),
                          transmittance_parameters(air, vec2<T>(a, b), size, 3),
                          altitude_sun_parameters(air, vec2<T>(a, b), size, 3)}) {
                        CHECK(at.altitude >= T(0));
                        CHECK(at.altitude <= air.top_altitude);
                        CHECK(at.mu >= T(-1));
                        CHECK(at.mu <= T(1));
                    }
                }
            }
        }
    }
}

TEST_SUITE_END();
