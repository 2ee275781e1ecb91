#include <doctest/doctest.h>
#include <airlight/scattering_mapping.hpp>

#include "mapping_round_trip.hpp"

using namespace airlight;
using namespace airlight_test;

namespace {

/// Half the texels of x_mu on the ground's row have no rays of their own: on the ground every ray down ends
/// at once.
template <typename T>
bool down_from_the_ground(const ScatteringPoint<T>& at) {
    return at.reaches_ground && at.altitude <= T(0);
}

}  // namespace

TEST_SUITE_BEGIN("scattering_mapping");

TEST_CASE_TEMPLATE("the plain table is even in altitude, view and sun", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    // Exact: halves and quarters.
    const vec3<T> uvw = linear_inscatter_uvw(air, T(0.5) * air.top_altitude, T(0), T(1), 32, 64, 8);
    CHECK(uvw == vec3<T>(T(0.5), T(0.5), T(0.9375L)));
    const AltitudeViewSun<T> at = linear_inscatter_parameters(air, uvw, 32, 64, 8);
    CHECK(at.altitude == T(0.5) * air.top_altitude);
    CHECK(at.mu == T(0));
    CHECK(at.mu_s == T(1));
    CHECK_FALSE(at.reaches_ground);
    CHECK(linear_inscatter_parameters(air, vec3<T>(T(0), T(0), T(0)), 32, 64, 8).reaches_ground);
}

TEST_CASE_TEMPLATE("the improved table has the horizon in its middle and half of its heights below a quarter",
                   T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const T lowest = lowest_sun_cosine(air);
    const T h = T(0.25L) * air.top_altitude;
    const T horizon = horizon_cosine(air.ground_radius, h);
    const vec3<T> up = inscatter_uvw(air, h, horizon, T(1), false, lowest, 31, 64, 8);
    CHECK(up.x == T(0.5));            // exact: the root of a quarter is the middle of an odd number
    CHECK(up.y == T(32.5L) / T(64));  // exact: the first texel above
    CHECK(up.z == T(0.9375L));
    const vec3<T> down = inscatter_uvw(air, h, horizon, lowest, true, lowest, 31, 64, 8);
    CHECK(down.y == T(31.5L) / T(64));  // exact: the first texel below
    CHECK(down.z == T(0.0625L));
    // The fifth root: a hundred-thousandth of the way to the zenith is a tenth of the half.
    const vec3<T> near_horizon = inscatter_uvw(air, T(0), T(1e-5L), T(0), false, lowest, 31, 64, 8);
    CHECK_WITHIN(compare_ulp("inscatter_uvw.y", {}, near_horizon.y, 0.5L + (0.5L + 0.1L * 31) / 64), 4.0L);
}

TEST_CASE_TEMPLATE("below the ground a table of scattered light is read at the ground", T, float, double) {
    // A source disagrees with itself: one function clamps an altitude at the ground, another takes its
    // absolute value.
    const Atmosphere<T> air = earth<T>();
    const T lowest = lowest_sun_cosine(air);
    for (const T depth : {T(1), T(1e3), T(6.36e6), T(1e9)}) {
        for (const T mu : {T(-1), T(-0.3L), T(0), T(0.2L), T(1)}) {
            const bool ground = mu < T(0);
            const auto lookup = [&](T altitude) {
                return scattering_lookup(air, altitude, mu, T(0.4L), T(0.1L), ground, lowest, 8, 32, 64, 32);
            };
            // Exact: the same altitude after clamping.
            CHECK(linear_inscatter_uvw(air, -depth, mu, T(0.4L), 32, 64, 32) ==
                  linear_inscatter_uvw(air, T(0), mu, T(0.4L), 32, 64, 32));
            CHECK(inscatter_uvw(air, -depth, mu, T(0.4L), ground, lowest, 32, 64, 32) ==
                  inscatter_uvw(air, T(0), mu, T(0.4L), ground, lowest, 32, 64, 32));
            CHECK(lookup(-depth).first == lookup(T(0)).first);
            CHECK(lookup(-depth).second == lookup(T(0)).second);
            CHECK(lookup(-depth).weight == lookup(T(0)).weight);
        }
    }
}

TEST_CASE_TEMPLATE("the lowest sun is 30 degrees down on Earth, and any on a world that is mostly air", T,
                   float, double, long double) {
    Atmosphere<T> air = earth<T>();
    air.ground_radius = T(6.36e6L);
    air.top_altitude = T(1e5L);
    // By angles: the dip of the horizon from the top, three times.
    const long double dip = std::acos(6360.0L / 6460.0L);
    CHECK_WITHIN(compare_ulp("lowest_sun_cosine", {}, lowest_sun_cosine(air), -std::sin(3 * dip)), 8.0L);
    CHECK(std::sin(3 * dip) == doctest::Approx(0.50428));
    // From 30 degrees of dip on the sun lights some air in sight at every hour.
    air.ground_radius = T(1e3L);
    air.top_altitude = T(154);  // 1000 (2 / sqrt(3) - 1) = 154.7
    CHECK(lowest_sun_cosine(air) > T(-1));
    CHECK(lowest_sun_cosine(air) < T(-0.999L));
    air.top_altitude = T(155);
    CHECK(lowest_sun_cosine(air) == T(-1));
    air.top_altitude = T(0);
    CHECK(lowest_sun_cosine(air) == T(0));
}

TEST_CASE_TEMPLATE("four dimensions: the horizon is at both ends, zenith and nadir in the middle", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const T lowest = lowest_sun_cosine(air);
    const T h = T(1e4);
    const T horizon = horizon_cosine(air.ground_radius, h);
    const auto v = [&](T mu, bool ground) {
        return scattering_lookup(air, h, mu, T(0.5), T(0), ground, lowest, 8, 32, 128, 32).first.y;
    };
    CHECK(v(T(1), false) == T(64.5L) / T(128));  // exact: x = 0
    CHECK(v(T(-1), true) == T(63.5L) / T(128));
    CHECK(v(horizon, false) == T(127.5L) / T(128));  // exact: x = 1, the same product twice
    // The root of a roundoff: 0.02 of a texel in float.
    CHECK(std::fabs(v(horizon, true) - T(0.5) / T(128)) < T(0.02L) / T(128));
}

TEST_CASE_TEMPLATE("four dimensions: the suns are from the lowest to the zenith, and nu mixes two planes", T,
                   float, double) {
    const Atmosphere<T> air = earth<T>();
    const T lowest = lowest_sun_cosine(air);
    const auto look = [&](T mu_s, T nu) {
        return scattering_lookup(air, T(0), T(1), mu_s, nu, false, lowest, 8, 32, 128, 32);
    };
    CHECK(look(lowest, T(-1)).first.x == T(0.5) / T(256));  // exact: first texel of the first plane
    CHECK(look(T(1), T(-1)).first.x == T(31.5L) / T(256));
    CHECK(look(T(1), T(1)).first.x == T(255.5L) / T(256));
    CHECK(look(T(1), T(1)).second.x == T(255.5L) / T(256));  // no plane behind the last
    const ScatteringLookup<T> between = look(T(1), T(0));    // 3.5 of 7
    CHECK(between.weight == T(0.5));
    CHECK(between.first.x == T(127.5L) / T(256));
    CHECK(between.second.x == T(159.5L) / T(256));
}

TEST_CASE_TEMPLATE("every texel of a table of scattered light comes back to its own centre", T, float,
                   double) {
    RoundTrip linear, improved, four;
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        const T lowest = lowest_sun_cosine(air);
        for_each_centre<T>(32, 32, 16, [&](const vec3<T>& centre) {
            const AltitudeViewSun<T> l = linear_inscatter_parameters(air, centre, 32, 32, 16);
            const vec3<T> l_back = linear_inscatter_uvw(air, l.altitude, l.mu, l.mu_s, 32, 32, 16);
            const AltitudeViewSun<T> i = inscatter_parameters(air, centre, lowest, 32, 32, 16);
            const vec3<T> i_back =
                inscatter_uvw(air, i.altitude, i.mu, i.mu_s, i.reaches_ground, lowest, 32, 32, 16);
            for (int axis = 0; axis < 3; ++axis) {
                const int size = axis == 2 ? 16 : 32;
                linear.add(world.name, centre[axis], l_back[axis], size);
                improved.add(world.name, centre[axis], i_back[axis], size);
            }
        });
        for_each_centre<T>(8 * 32, 128, 32, [&](const vec3<T>& centre) {
            const ScatteringPoint<T> at = scattering_parameters(air, centre, lowest, 8, 32, 128, 32);
            const ScatteringLookup<T> back = scattering_lookup(air, at.altitude, at.mu, at.mu_s, at.nu,
                                                               at.reaches_ground, lowest, 8, 32, 128, 32);
            // nu = -1, -5/7 ... 1 rounds to either side of a plane.
            const T u = back.weight > T(0.5) ? back.second.x : back.first.x;
            four.add(world.name, centre.x, u, 8 * 32);
            four.add(world.name, T(0), std::fmin(back.weight, T(1) - back.weight), 7);
            four.add(world.name, centre.z, back.first.z, 32);
            if (!down_from_the_ground(at)) {
                four.add(world.name, centre.y, back.first.y, 128);
            }
        });
    }
    linear.print("linear in-scatter");
    improved.print("improved in-scatter");
    four.print("four dimensions");
    const double roundoff = static_cast<double>(unit_roundoff<T>());
    CHECK_MESSAGE(linear.worst() <= 4 * 32 * roundoff, linear.story());  // 4 roundoffs of the size
    // On the first of 15 texels a change of mu counts 15^4 / 5 fold, times 15 texels; mu and the horizon
    // have 2 roundoffs each.
    CHECK_MESSAGE(improved.worst() <= 4 * roundoff * 15 * 15 * 15 * 15 * 15 / 5, improved.story());
    // The root of 16 roundoffs of the ray's length squared, times the 64 texels of the lower half.
    CHECK_MESSAGE(four.worst() <= 64 * std::sqrt(16 * roundoff), four.story());
}

TEST_CASE_TEMPLATE("the view's coordinate runs one way on each side of the horizon", T, float, double) {
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        const T lowest = lowest_sun_cosine(air);
        for (int i = 0; i <= 10; ++i) {
            const T h = air.top_altitude * T(i) / T(10);
            const T horizon = horizon_cosine(air.ground_radius, h);
            const T slack = std::sqrt(std::numeric_limits<T>::epsilon());  // the root of a roundoff
            T before[4] = {T(-1), T(2), T(-1), T(2)};
            for (int j = 0; j <= 100; ++j) {
                const T up = horizon + (T(1) - horizon) * T(j) / T(100);
                const T down = horizon - (T(1) + horizon) * T(j) / T(100);
                const T y[4] = {
                    inscatter_uvw(air, h, up, T(0), false, lowest, 8, 64, 8).y,
                    inscatter_uvw(air, h, down, T(0), true, lowest, 8, 64, 8).y,
                    T(1) - scattering_lookup(air, h, up, T(0), T(0), false, lowest, 2, 2, 64, 8).first.y,
                    T(1) - scattering_lookup(air, h, down, T(0), T(0), true, lowest, 2, 2, 64, 8).first.y};
                CHECK(y[0] >= before[0]);
                CHECK(y[1] <= before[1]);
                CHECK(y[2] >= before[2] - slack);
                CHECK(y[3] <= before[3] + slack);
                CHECK(y[0] > T(0.5));
                CHECK(y[1] < T(0.5));
                for (int n = 0; n < 4; ++n) {
                    before[n] = y[n];
                }
            }
        }
    }
}

TEST_CASE_TEMPLATE("a nu that view and sun cannot have becomes the closest one they can", T, float, double) {
    CHECK(possible_nu(T(1), T(0.5), T(0)) == T(0.5));      // exact: straight up there is one nu only
    CHECK(possible_nu(T(0), T(0), T(0.25L)) == T(0.25L));  // level: every nu
    CHECK(possible_nu(T(0.6L), T(0.6L), T(-1)) == doctest::Approx(0.36 - 0.64));  // a float's digits
}

TEST_CASE_TEMPLATE("whatever a mapping of scattered light is given, it stays on the table", T, float,
                   double) {
    std::vector<T> numbers = odd_numbers<T>();
#ifndef __FAST_MATH__
    for (const T none : no_numbers<T>()) {
        numbers.push_back(none);
    }
#endif
    const auto on_table = [](const vec3<T>& uvw) {
        return uvw.x >= T(0) && uvw.x <= T(1) && uvw.y >= T(0) && uvw.y <= T(1) && uvw.z >= T(0) &&
               uvw.z <= T(1);
    };
    const auto in_range = [](const auto& at, T top) {
        return at.altitude >= T(0) && at.altitude <= top && at.mu >= T(-1) && at.mu <= T(1) &&
               at.mu_s >= T(-1) && at.mu_s <= T(1);
    };
    for (const TableWorld& world : all_table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        const T lowest = std::fmin(lowest_sun_cosine(air), T(-0.1L));
        for (const T a : numbers) {
            for (const T b : numbers) {
                for (const T c : numbers) {
                    CAPTURE(world.name);
                    CAPTURE(a);
                    CAPTURE(b);
                    CAPTURE(c);
                    const bool ground = b < T(0);
                    CHECK(on_table(linear_inscatter_uvw(air, a, b, c, 3, 4, 5)));
                    CHECK(on_table(inscatter_uvw(air, a, b, c, ground, lowest, 3, 4, 5)));
                    const ScatteringLookup<T> look =
                        scattering_lookup(air, a, b, c, c, ground, lowest, 3, 4, 6, 5);
                    CHECK(on_table(look.first));
                    CHECK(on_table(look.second));
                    CHECK(look.weight >= T(0));
                    CHECK(look.weight <= T(1));
                    const vec3<T> uvw(a, b, c);
                    CHECK(in_range(linear_inscatter_parameters(air, uvw, 3, 4, 5), air.top_altitude));
                    CHECK(in_range(inscatter_parameters(air, uvw, lowest, 3, 4, 5), air.top_altitude));
                    CHECK(in_range(scattering_parameters(air, uvw, lowest, 3, 4, 6, 5), air.top_altitude));
                }
            }
        }
    }
}

TEST_SUITE_END();
