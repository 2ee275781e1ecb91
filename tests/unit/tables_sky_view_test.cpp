#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/table_storage.hpp>
#include <airlight/tables/hillaire.hpp>
#include <airlight/tables/sky_view.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

#include "error_metrics.hpp"
#include "half.hpp"
#include "promises.hpp"
#include "samplers.hpp"

using namespace airlight;
using namespace airlight_test;

namespace {

constexpr double degree = 0.017453292519943295;

double luminance(const vec3<double>& radiance) {
    return 0.2126 * radiance.x + 0.7152 * radiance.y + 0.0722 * radiance.z;
}

/// A table and its sun.
struct Sky {
    Atmosphere<double> air;
    Viewpoint<double> eye;
    vec3<double> to_sun;
    Table<vec3<double>> table;
};

Sky sky(double altitude, double sun, int width, int height) {
    const Atmosphere<double> air = earth<double>();
    const vec3<double> to_sun(std::cos(sun * degree), 0, std::sin(sun * degree));
    return Sky{air, Viewpoint<double>{altitude, vec3<double>(0, 0, 1)}, to_sun,
               bake_sky_view(air, altitude, to_sun.z, width, height)};
}

vec3<double> direct(const Sky& sky, const vec3<double>& direction) {
    return single_scattering<double>(sky.air, sky.eye, direction, sky.to_sun, no_surface<double>()).radiance;
}

vec3<double> looked_up(const Sky& sky, const vec3<double>& direction) {
    return sky_view_radiance(sky.table, sky.air, sky.eye, direction, sky.to_sun);
}

vec3<double> towards(double mu, double azimuth) {
    const double sine = std::sqrt((1 - mu) * (1 + mu));
    return vec3<double>(sine * std::cos(azimuth), sine * std::sin(azimuth), mu);
}

/// Errors of the luminance, as shares of it or, where that is more, of a hundredth of the mean.
ErrorMetrics look_up_errors(const Sky& sky, bool upper_half) {
    Random random(71);
    std::vector<double> off;
    std::vector<double> known;
    double mean = 0;
    const double horizon = horizon_cosine(sky.air.ground_radius, sky.eye.altitude);
    for (int i = 0; i < 2000; ++i) {
        const double share = random.unit();
        const double up = i % 2 == 0 ? share : share * share * share;
        const double mu = upper_half ? horizon + (1 - horizon) * up : horizon - (1 + horizon) * up;
        const vec3<double> direction = towards(mu, random.uniform(0, 3.141592653589793));
        known.push_back(luminance(direct(sky, direction)));
        off.push_back(std::fabs(luminance(looked_up(sky, direction)) - known.back()));
        mean += known.back() / 2000;
    }
    for (std::size_t i = 0; i < off.size(); ++i) {
        off[i] = off[i] > 0 ? off[i] / std::fmax(known[i], 0.01 * mean) : 0;
    }
    return error_metrics(off);
}

}  // namespace

TEST_SUITE_BEGIN("tables_sky_view");

TEST_CASE("the sky from 192 x 108 texels") {
    for (const double altitude : {2.0, 1e3, 1e4}) {
        for (const double sun : {60.0, 10.0, 0.5, -3.0, -6.0}) {
            const Sky seen = sky(altitude, sun, 192, 108);
            const ErrorMetrics above = look_up_errors(seen, true);
            const ErrorMetrics below = look_up_errors(seen, false);
            std::printf(
                "sky view 192 x 108, %.0f m, sun %.1f: sky median %.1e p95 %.1e max %.1e, ground p95 %.1e\n",
                altitude, sun, above.median, above.p95, above.largest, below.p95);
            // The printed errors with some to spare; by night the shadow's edge runs through texels.
            CHECK(above.median <= 1e-3);
            CHECK(above.p95 <= (sun > 0 ? 0.006 : 0.025));
            CHECK(below.p95 <= (altitude < 10 ? 0.11 : 0.006));
        }
    }
}

TEST_CASE("a hook adds what was scattered more often") {
    const Atmosphere<double> air = earth<double>();
    const Table<vec3<double>> hillaire = bake_hillaire(air, 16, 16);
    const HillaireLight<double> more{&air, &hillaire};
    const Table<vec3<double>> once = bake_sky_view(air, 2.0, 0.5, 16, 16);
    const Table<vec3<double>> all = bake_sky_view(air, 2.0, 0.5, 16, 16, more);
    for (const int j : {0, 4, 7}) {
        // Between a tenth and all of the blue sky is light of higher orders; straight up it is 0.4 of the
        // first.
        const double share = all.texel(5, j, 0).z / once.texel(5, j, 0).z - 1;
        CHECK(share > 0.1);
        CHECK(share < 1.0);
    }
}

TEST_CASE("four times the texels, a fourth of the usual error") {
    const double coarse = look_up_errors(sky(1e3, 30, 48, 54), true).p95;
    const double middle = look_up_errors(sky(1e3, 30, 96, 108), true).p95;
    const double fine = look_up_errors(sky(1e3, 30, 192, 216), true).p95;
    std::printf("sky view, sun 30: p95 %.1e with 48 x 54, %.1e with 96 x 108, %.1e with 192 x 216\n", coarse,
                middle, fine);
    CHECK(coarse / middle >= 3);  // linear filtering is of second order: 4 in the limit
    CHECK(middle / fine >= 3);
}

TEST_CASE("no seam at the horizon: each side is as right as the sky farther up") {
    for (const double altitude : {2.0, 1e3, 1e4}) {
        const Sky seen = sky(altitude, 20, 192, 108);
        const double horizon = horizon_cosine(seen.air.ground_radius, altitude);
        for (const double off : {1e-6, 1e-5, 1e-4, 1e-3}) {
            for (const double azimuth : {0.1, 1.5, 3.0}) {
                const vec3<double> above = towards(horizon + off, azimuth);
                INFO("altitude ", altitude, " off the horizon by ", off, " azimuth ", azimuth);
                CHECK(luminance(looked_up(seen, above)) / luminance(direct(seen, above)) ==
                      doctest::Approx(1).epsilon(0.01));
                const vec3<double> below = towards(horizon - off, azimuth);
                CHECK(luminance(looked_up(seen, below)) / luminance(direct(seen, below)) ==
                      doctest::Approx(1).epsilon(altitude < 10 ? 0.35 : 0.02));  // 5 km away, 2 m down
            }
        }
    }
}

TEST_CASE("in half precision the night's sky is lost, its square root is not") {
    const Sky day = sky(2, 60, 48, 54);
    const Sky night = sky(2, -9, 48, 54);
    const auto worst = [](const Sky& sky, bool root) {
        double brightest = 0;
        for (const vec3<double>& texel : sky.table.texels) {
            brightest = std::fmax(brightest, texel.y);
        }
        double off = 0;
        for (const vec3<double>& texel : sky.table.texels) {
            if (texel.y > 1e-4 * brightest) {
                const double kept =
                    root ? light_from_stored(as_half(stored_light(texel))).y : as_half(texel).y;
                off = std::fmax(off, std::fabs(kept / texel.y - 1));
            }
        }
        return off;
    };
    std::printf("sky view in half: by day off by %.1e, sun 9 degrees down %.1e; square roots %.1e and %.1e\n",
                worst(day, false), worst(night, false), worst(day, true), worst(night, true));
    CHECK(worst(night, false) >= 0.1);
    CHECK(worst(day, true) <= 1e-3);  // twice half precision's roundoff
    CHECK(worst(night, true) <= 1e-3);
}

TEST_CASE_TEMPLATE("sizes of 1, worlds without air, eyes in space and below the ground give amounts", T,
                   float, double) {
    Atmosphere<T> none = earth<T>();
    none.top_altitude = T(0);
    Atmosphere<T> zero = earth<T>();
    zero.rayleigh_scattering = zero.mie_scattering = zero.mie_absorption = zero.ozone_absorption =
        vec3<T>(T(0));
    Random random(72);
    for (const Atmosphere<T>& air : {earth<T>(), mars<T>(), none, zero}) {
        for (const int size : {1, 2, 5}) {
            for (const T altitude : {T(-10), T(0), T(2), T(1e5L), T(1e8L)}) {
                const T mu_s = T(random.uniform(-1, 1));
                const Table<vec3<T>> table = bake_sky_view(air, altitude, mu_s, size, size);
                const Viewpoint<T> eye{altitude, vec3<T>(T(0), T(0), T(1))};
                for (int i = 0; i < 20; ++i) {
                    const vec3<T> direction = i == 0 ? eye.up : random.direction<T>();
                    CHECK_UNARY(
                        is_amount(sky_view_radiance(table, air, eye, direction, random.direction<T>())));
                }
            }
        }
    }
}

TEST_SUITE_END();
