#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/transmittance_table.hpp>

#include <cmath>

#include "extremes.hpp"
#include "mapping_round_trip.hpp"
#include "promises.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "worlds.hpp"

using namespace airlight;
using namespace airlight_test;

TEST_SUITE_BEGIN("transmittance_table");

TEST_CASE_TEMPLATE("the guess is Chapman's function along the horizon, and close to it elsewhere", T, float,
                   double) {
    double most = 0;
    double least = 0;
    for (const T x : {T(50), T(100), T(800), T(5300), T(1e6)}) {
        const T along = chapman(x, T(0), T(1));
        // Relative 2e-5 at x = 50: exponential_from_perigee's formula.
        CHECK(std::fabs(slant_guess(x, T(0)) / along - 1) <= T(2.1e-5L));
        for (int i = 0; i <= 4000; ++i) {
            const T mu = T(i) / T(4000) * T(i) / T(4000);
            const T exact_air = chapman(x, mu, safe_sqrt((T(1) - mu) * (T(1) + mu)));
            const double off = double(slant_guess(x, mu) / exact_air) - 1;
            most = std::fmax(most, off);
            least = std::fmin(least, off);
        }
    }
    std::printf("slant_guess: %.4f to %.4f of chapman\n", 1 + least, 1 + most);
    CHECK(most <= 0.06);     // the docstring's
    CHECK(least >= -0.013);  // the same; at x = 50
}

TEST_CASE_TEMPLATE("the guess's excess is what a texel holds", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const T mu = T(0.05L);
    const T x = air.ground_radius / air.rayleigh_scale_height;
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    const vec2<T> texel = slant_texel<T>(air, T(0), mu);
    // Formed in the same order but for the product with 1 / H: a few roundoffs of 1.
    CHECK(std::fabs(slant_guess(x, mu) * (T(1) + texel.x) / chapman(x, mu, sine) - 1) <=
          T(32) * std::numeric_limits<T>::epsilon());
    CHECK(slant_texel<T, NoMie>(air, T(0), mu).y == T(0));  // exact: left out
}

TEST_CASE_TEMPLATE("a slant's place leads back to the texel", T, float, double) {
    RoundTrip trip;
    for (const TableWorld& world : all_table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        for_each_centre<T>(64, 32, 1, [&](const vec3<T>& centre) {
            const vec2<T> uv(centre.x, centre.y);
            const AltitudeCosine<T> at = slant_parameters(air, uv, 64, 32);
            const vec2<T> back = slant_uv(air, at.altitude, at.mu, 64, 32);
            trip.add(world.name, uv.x, back.x, 64);
            if (air.top_altitude > T(0)) {  // else all altitudes are one
                trip.add(world.name, uv.y, back.y, 32);
            }
        });
    }
    trip.print("slant");
    INFO(trip.story());
    CHECK(trip.worst() <=
          64 * 16 * double(std::numeric_limits<T>::epsilon()));  // 2 x 6 roundoffs of the size
}

TEST_CASE_TEMPLATE("the horizon is the first column, the zenith the last", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    CHECK(slant_uv(air, T(0), T(0), 64, 32) == vec2<T>(T(0.5) / T(64), T(0.5) / T(32)));
    CHECK(slant_uv(air, air.top_altitude, T(1), 64, 32) == vec2<T>(T(63.5L) / T(64), T(31.5L) / T(32)));
    CHECK(slant_parameters(air, vec2<T>(T(0), T(0)), 64, 32).mu == T(0));
    CHECK(slant_parameters(air, vec2<T>(T(1), T(0)), 64, 32).mu == T(1));

    // Air without height: every direction but the horizontal one has the vertical one's place, and back.
    Atmosphere<T> flat = air;
    flat.rayleigh_scale_height = flat.mie_scale_height = T(0);
    CHECK(slant_scale(flat) == T(0));
    CHECK(slant_uv(flat, T(0), T(0), 64, 32).x == T(0.5) / T(64));
    for (const T mu : {T(1e-3L), T(0.5), T(1)}) {
        CHECK(slant_uv(flat, T(0), mu, 64, 32).x == T(63.5L) / T(64));
    }
    CHECK(slant_parameters(flat, vec2<T>(T(0), T(0)), 64, 32).mu == T(0));
    CHECK(slant_parameters(flat, vec2<T>(T(63.5L) / T(64), T(0)), 64, 32).mu == T(1));
}

TEST_CASE_TEMPLATE("without a table the guess stands: 6 % of the molecules and the aerosol", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    Random random(31);
    for (int i = 0; i < 500; ++i) {
        const T altitude = T(random.uniform(0, 6e4));
        const T mu = T(random.uniform(0, 1));
        const Column<T> guessed = column_from_slants<T>(air, altitude, mu, 64, 32);
        const Column<T> known = column_to_space<T>(air, altitude, mu);
        CHECK(guessed.rayleigh >= known.rayleigh * T(0.995L));  // the air above the top is guessed too
        CHECK(guessed.rayleigh <= known.rayleigh * T(1.07L));
        CHECK(guessed.mie <= known.mie * T(1.07L));
    }
}

TEST_CASE_TEMPLATE("nothing passes the planet, and all of it where there is no planet", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    CHECK(transmittance_from_slants<T>(air, T(0), T(-0.1L), 64, 32) == vec3<T>(T(0)));
    const vec3<T> through = transmittance_from_slants<T, NoShadow>(air, T(5e3L), T(-0.04L), 64, 32);
    CHECK(through.x > T(0));
    CHECK(transmittance_from_slants<T>(airless(air), T(10), T(0.5), 64, 32) ==
          vec3<T>(T(1)));  // exact: exp(0)
}

TEST_CASE_TEMPLATE("every atmosphere, altitude and cosine gives a share", T, float, double) {
    Random random(32);
    for (int i = 0; i < 20000; ++i) {
        const Atmosphere<T> air = any_atmosphere<T>(random);
        const T altitude = any_altitude<T>(random, air);
        const T mu = cosine<T>(random);
        const vec3<T> got = transmittance_from_slants<T>(air, altitude, mu, 64, 32);
        const vec2<T> texel = slant_texel<T>(air, table_altitude(air, altitude), std::fabs(mu));
        INFO("h ", double(altitude), " mu ", double(mu), " H ", double(air.rayleigh_scale_height), " R ",
             double(air.ground_radius));
        CHECK_UNARY(is_share(got));
        CHECK_UNARY(is_finite(texel.x));
        CHECK_UNARY(is_finite(texel.y));
    }
}

TEST_SUITE_END();
