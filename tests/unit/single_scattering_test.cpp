#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "table.hpp"
#include "views.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename Scene, typename T>
Scattered<T> march(const Atmosphere<T>& planet, const View<T>& view, int steps) {
    return single_scattering_marched<T, Scene>(planet, view.eye, view.direction, view.to_sun, view.distance,
                                               steps);
}

// Views that cross the edge of the planet's shadow: there the midpoint rule is of first order.
bool crosses_shadow(const std::string& view) {
    return view == "sunset_horizon" || view == "twilight_zenith" || view == "twilight_horizon" ||
           view == "orbit_limb" || view == "orbit_terminator" || view == "far_limb";
}

}  // namespace

TEST_SUITE_BEGIN("single_scattering");

TEST_CASE_TEMPLATE("a kilometre of even, thin gas adds scattering times phase times length", T, float, double,
                   long double) {
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scale_height = T(1e30L);
    planet.rayleigh_scattering = vec3<T>(T(1e-20L), T(2e-20L), T(4e-20L));
    planet.mie_scattering = planet.mie_absorption = planet.ozone_absorption = vec3<T>(T(0));
    for (const int steps : {1, 7, 64}) {
        // Straight up with the sun at right angles: phase 3 / (16 pi). vec3(0, 0, 1) has no rounding of its
        // own.
        const Scattered<T> seen = single_scattering_marched<T>(
            planet, standing(T(100)), vec3<T>(T(0), T(0), T(1)), vec3<T>(T(1), T(0), T(0)), T(1000), steps);
        for (int i = 0; i < 3; ++i) {
            const long double sigma = planet.rayleigh_scattering[i];
            const long double expected = sigma * 1000 * 0.0596831036594607508L;
            // Modelling: the ray to the sun of 1130 km dims the light by its depth.
            const long double dimmed = expected * sigma * 1.2e6L;
            // Step, sum of `steps` terms, phase and two products round.
            const long double rounded =
                (8.0L + static_cast<long double>(steps) / 4) * ulp_spacing<T>(expected);
            CAPTURE(exact(seen.radiance[i]));
            CHECK(std::fabs(static_cast<long double>(seen.radiance[i]) - expected) <= rounded + dimmed);
            CHECK(std::fabs(static_cast<long double>(seen.transmittance[i]) - 1) <=
                  1000 * sigma + unit_roundoff<T>());
        }
    }
}

TEST_CASE_TEMPLATE("the coefficient enters once: twice the gas, twice the light in thin air", T, float,
                   double, long double) {
    // Our reading of a source whose scattered light carries the coefficient twice and leaves out the density.
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scattering = vec3<T>(T(1e-20L));
    planet.mie_scattering = planet.mie_absorption = planet.ozone_absorption = vec3<T>(T(0));
    const View<T> view = {standing(T(100)), slope<T>(30), slope<T>(60, 40), no_surface<T>()};
    const T once = march<DefaultScene>(planet, view, 16).radiance.x;
    planet.rayleigh_scattering *= T(2);
    const T twice = march<DefaultScene>(planet, view, 16).radiance.x;
    // Exact but for the depth, 1e-20 times some 300 km of air, which the wider types see.
    CHECK_WITHIN(
        compare_relative("single_scattering_marched.radiance", {}, twice, 2 * static_cast<long double>(once)),
        3e-15L);
    // Density inside the integral: with half the scale height there is half the air above the eye, to 100 m
    // of 8 km.
    planet.rayleigh_scale_height /= 2;
    const View<T> up = {standing(T(0)), slope<T>(90), slope<T>(90), no_surface<T>()};
    const Scattered<T> low = march<DefaultScene>(planet, up, 2048);
    planet.rayleigh_scale_height *= 2;
    const Scattered<T> high = march<DefaultScene>(planet, up, 2048);
    // Midpoint error of 49 m steps, 1e-5; e^-12.5 = 4e-6 of the thicker air lies above the top; float sums
    // 2048 terms.
    CHECK_WITHIN(
        compare_relative("single_scattering_marched.radiance", {}, high.radiance.x / low.radiance.x, 2.0L),
        5e-5L);
}

TEST_CASE_TEMPLATE("the scene chooses the aerosol's phase function", T, float, double, long double) {
    for (const T c : {T(-1), T(0.3L), T(1)}) {
        // Exact: the same calls.
        CHECK(mie_phase<T>(c, T(0.76L)) == cornette_shanks_phase(c, T(0.76L)));
        CHECK(mie_phase<T, HenyeyGreenstein>(c, T(0.76L)) == henyey_greenstein_phase(c, T(0.76L)));
        CHECK(mie_phase<T, Fog>(c, T(12)) == fog_phase(c, T(12)));
    }
    const View<T> view = {standing(T(100)), slope<T>(5), slope<T>(15), no_surface<T>()};
    CHECK(march<HenyeyGreenstein>(earth<T>(), view, 8).radiance.x !=
          march<DefaultScene>(earth<T>(), view, 8).radiance.x);
    CHECK(march<HenyeyGreenstein>(earth<T>(), view, 8).transmittance ==
          march<DefaultScene>(earth<T>(), view, 8).transmittance);
}

TEST_CASE_TEMPLATE("phase functions are applied once, after the march, to molecules and aerosol apart", T,
                   float, double, long double) {
    // The aerosol's light is in proportion to its phase function; the rest is the light of the same air with
    // an aerosol that only absorbs.
    Random random(147);
    Worst worst;
    int lit = 0;
    Atmosphere<T> sharp = earth<T>();
    sharp.mie_g = T(0.76L);
    Atmosphere<T> soft = sharp;
    soft.mie_g = T(0.25L);
    const Atmosphere<T> dark = without_aerosol_glow(sharp);
    for (int i = 0; i < 1000; ++i) {
        const View<T> view = random_view<T>(random);
        const T molecules = march<DefaultScene>(dark, view, 16).radiance.y;
        const T with_sharp = march<DefaultScene>(sharp, view, 16).radiance.y;
        const T with_soft = march<DefaultScene>(soft, view, 16).radiance.y;
        const T cosine = glm::clamp(dot_product(view.direction, view.to_sun), T(-1), T(1));
        const long double ratio =
            static_cast<long double>(mie_phase<T>(cosine, T(0.76L))) / mie_phase<T>(cosine, T(0.25L));
        const long double expected = (static_cast<long double>(with_soft) - molecules) * ratio;
        worst.add(compare_roundoffs("single_scattering_marched.radiance", {{"cosine", cosine}},
                                    with_sharp - molecules, expected, with_sharp + with_soft * ratio));
        lit += with_sharp > molecules ? 1 : 0;
    }
    CHECK(lit > 100);
    CHECK_WORST(worst, 4.0L);  // depths are the same numbers: two products and a sum round (measured: 0.92)
}

TEST_CASE_TEMPLATE("no ray scatters more than it extinguishes", T, float, double, long double) {
    // Energy: what is scattered into the ray, over the phase function, is at most 1 - transmittance. The
    // midpoint rule keeps this exactly, because x <= 2 sinh(x / 2); rounding of 1 - T and of the sums is what
    // is left.
    Random random(141);
    for (int i = 0; i < 3000; ++i) {
        const View<T> view = random_view<T>(random);
        const Scattered<T> seen = march<DefaultScene>(earth<T>(), view, 16);
        const T c = glm::dot(view.direction, view.to_sun);
        const T phase = glm::max(rayleigh_phase(c), cornette_shanks_phase(c, T(0.8L)));
        for (int k = 0; k < 3; ++k) {
            CHECK_UNARY(seen.radiance[k] >= T(0));
            CHECK_UNARY(seen.transmittance[k] >= T(0) && seen.transmittance[k] <= T(1));
            CHECK_UNARY(seen.radiance[k] <=
                        phase * (T(1) - seen.transmittance[k] + 64 * std::numeric_limits<T>::epsilon()));
        }
    }
}

TEST_CASE_TEMPLATE("the ray's transmittance is that of its column", T, float, double, long double) {
    Random random(142);
    Worst worst;
    for (int i = 0; i < 1000; ++i) {
        const T h = T(random.log_uniform(1, 9e4));
        const vec3<T> direction = slope<T>(random.uniform(0.0, 90));
        const T distance = T(random.log_uniform(10, 1e5));
        const Scattered<T> seen =
            single_scattering_marched<T>(earth<T>(), standing(h), direction, slope<T>(40), distance, 32);
        const Column<T> air = column_marched<T>(earth<T>(), h, direction.z, distance, 32);
        const vec3<T> depth = column_optical_depth<T>(earth<T>(), air);
        for (int k = 0; k < 3; ++k) {
            const long double expected = std::exp(-static_cast<long double>(depth[k]));
            // The same samples summed in halves: 64 roundings of the depth, plus those of altitudes found
            // from two ways to write the ray, 3 roundoffs of the altitude and of the drop of up to 800 m,
            // over 1200 m.
            const long double lever = 64 + 6 * (static_cast<long double>(h) + distance) / 1200;
            worst.add(compare_roundoffs("single_scattering_marched.transmittance",
                                        {{"altitude", h}, {"mu", direction.z}, {"distance", distance}},
                                        seen.transmittance[k], expected, expected * (2 + lever * depth[k])));
        }
    }
    CHECK_WORST(worst, 1.0L);
}

TEST_CASE_TEMPLATE("twice the view turned by half a turn about the vertical is the same sky", T, float,
                   double, long double) {
    Random random(143);
    const auto turned = [](const vec3<T>& v) { return vec3<T>(-v.x, -v.y, v.z); };
    for (int i = 0; i < 500; ++i) {
        const View<T> view = random_view<T>(random);
        const View<T> other = {Viewpoint<T>{view.eye.altitude, turned(view.eye.up)}, turned(view.direction),
                               turned(view.to_sun), view.distance};
        // Exact: signs change in pairs.
        check_same(march<DefaultScene>(earth<T>(), view, 8), march<DefaultScene>(earth<T>(), other, 8));
    }
}

TEST_CASE("the sun's azimuth matters even where the phase function is the same on both sides") {
    // Our choice where a source drops the azimuth from its table: the sun's height at a sample depends on it.
    // Looking 5 degrees up towards and away from a sun on the horizon, the Rayleigh phase is equal.
    const Atmosphere<double> planet = earth<double>();
    const View<double> towards = {standing(2.0), slope<double>(5), slope<double>(0), no_surface<double>()};
    const View<double> away = {standing(2.0), slope<double>(5), slope<double>(0, 180), no_surface<double>()};
    const double difference =
        march<NoMie>(planet, away, 256).radiance.y / march<NoMie>(planet, towards, 256).radiance.y - 1;
    std::printf("sun on the horizon, 5 degrees up: away from it %+.0f %% against towards it, phase apart\n",
                100 * difference);
    CHECK(std::fabs(difference) > 0.05);
}

TEST_CASE_TEMPLATE("the sky does not depend on the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two
    Random random(144);
    const Atmosphere<T> scaled = rescaled(earth<T>(), k);
    for (int i = 0; i < 300; ++i) {
        const View<T> view = random_view<T>(random);
        const View<T> far = {Viewpoint<T>{k * view.eye.altitude, view.eye.up}, view.direction, view.to_sun,
                             k * view.distance};
        check_same(march<DefaultScene>(scaled, far, 8), march<DefaultScene>(earth<T>(), view, 8));
    }
}

TEST_CASE_TEMPLATE("a term that is off equals its coefficients set to zero", T, float, double, long double) {
    Random random(145);
    Atmosphere<T> no_mie = earth<T>();
    no_mie.mie_scattering = no_mie.mie_absorption = vec3<T>(T(0));
    Atmosphere<T> no_ozone = earth<T>();
    no_ozone.ozone_absorption = vec3<T>(T(0));
    for (int i = 0; i < 200; ++i) {
        const View<T> view = random_view<T>(random);
        // Exact: 0 times a finite column is added.
        check_same(march<NoMie>(earth<T>(), view, 8), march<DefaultScene>(no_mie, view, 8));
        check_same(march<NoOzone>(earth<T>(), view, 8), march<DefaultScene>(no_ozone, view, 8));
        check_same(march<NoOzone>(earth<T>(), view, 8), march<Lorentzian>(no_ozone, view, 8));
        // The planet's shadow only ever takes light away, and none where the sun stands high over all the
        // ray.
        const Scattered<T> with = march<DefaultScene>(earth<T>(), view, 8);
        const Scattered<T> without = march<NoShadow>(earth<T>(), view, 8);
        for (int c = 0; c < 3; ++c) {
            CHECK_UNARY(with.radiance[c] <= without.radiance[c]);
            CHECK_UNARY(with.transmittance[c] == without.transmittance[c]);
        }
        const View<T> noon = {view.eye, view.eye.up, view.eye.up, view.distance};
        check_same(march<DefaultScene>(earth<T>(), noon, 8), march<NoShadow>(earth<T>(), noon, 8));
    }
}

TEST_CASE_TEMPLATE("at night the air is black, and as clear as by day", T, float, double, long double) {
    const View<T> day = {standing(T(2)), slope<T>(30), slope<T>(60), no_surface<T>()};
    const View<T> night = {standing(T(2)), slope<T>(30), slope<T>(-60), no_surface<T>()};
    CHECK(march<DefaultScene>(earth<T>(), night, 32).radiance ==
          vec3<T>(T(0)));  // exact: every sample is hidden
    CHECK(march<DefaultScene>(earth<T>(), night, 32).transmittance ==
          march<DefaultScene>(earth<T>(), day, 32).transmittance);
}

TEST_CASE_TEMPLATE("in twilight only the air above the planet's shadow is lit", T, float, double,
                   long double) {
    // Sun 6 degrees down: straight up the shadow ends at R / cos 6 - R = 35.0 km.
    const vec3<T> sun = slope<T>(-6);
    const Scattered<T> below =
        single_scattering_marched<T>(earth<T>(), standing(T(0)), slope<T>(90), sun, T(34e3L), 64);
    const Scattered<T> above =
        single_scattering_marched<T>(earth<T>(), standing(T(0)), slope<T>(90), sun, T(37e3L), 64);
    CHECK(below.radiance == vec3<T>(T(0)));
    const Scattered<T> all =
        single_scattering_marched<T, NoShadow>(earth<T>(), standing(T(0)), slope<T>(90), sun, T(34e3L), 64);
    CHECK(all.transmittance == below.transmittance);
    CHECK(above.radiance.x >= T(0));
    // 60 km up, still in the sun though its light grazes the ground at 25 km.
    const Scattered<T> high =
        single_scattering_marched<T>(earth<T>(), standing(T(60e3L)), slope<T>(90), sun, no_surface<T>(), 64);
    CHECK(high.radiance.x > T(0));
}

TEST_CASE_TEMPLATE("in full shade there is no light, and the transmittance is as in the sun", T, float,
                   double, long double) {
    Random random(146);
    for (int i = 0; i < 200; ++i) {
        const View<T> view = random_view<T>(random);
        const Scattered<T> lit = march<DefaultScene>(earth<T>(), view, 8);
        const Scattered<T> dark = single_scattering_marched<T, DefaultScene>(
            earth<T>(), view.eye, view.direction, view.to_sun, view.distance, 8, Shaded{0.0});
        CHECK_UNARY(dark.radiance == vec3<T>(T(0)));  // exact: every term is times 0
        CHECK_UNARY(dark.transmittance == lit.transmittance);
        const Scattered<T> half = single_scattering_marched<T, DefaultScene>(
            earth<T>(), view.eye, view.direction, view.to_sun, view.distance, 8, Shaded{0.5});
        CHECK_UNARY(half.radiance == lit.radiance * T(0.5));  // exact: a power of two
        CHECK_UNARY(half.transmittance == lit.transmittance);
    }
}

/// A table's place taken by the closed form, or by half of it.
template <typename T>
struct ShareOfClosedForm {
    T share;
    vec3<T> operator()(const airlight::Atmosphere<T>& atmosphere, T altitude, T mu) const {
        return share * airlight::transmittance_to_space<T>(atmosphere, altitude, mu);
    }
};

TEST_CASE_TEMPLATE("a look-up takes the place of the closed form of the march", T, float, double,
                   long double) {
    const airlight::AlwaysLit lit;
    const auto light = [&](T share) {
        return single_scattering_marched<T, airlight::DefaultScene>(earth<T>(), standing(T(2)), slope<T>(30),
                                                                    slope<T>(10), no_surface<T>(), 16, lit,
                                                                    ShareOfClosedForm<T>{share});
    };
    const Scattered<T> computed = single_scattering_marched<T>(earth<T>(), standing(T(2)), slope<T>(30),
                                                               slope<T>(10), no_surface<T>(), 16);
    // The same calls in the same order; half of every term is exact.
    CHECK(light(T(1)).radiance == computed.radiance);
    CHECK(light(T(0.5)).radiance == T(0.5) * computed.radiance);
    CHECK(light(T(0.5)).transmittance == computed.transmittance);
}

TEST_CASE_TEMPLATE("the light of the near half and of the far half add up to that of the whole", T, float,
                   double, long double) {
    const View<T> view = {standing(T(100)), slope<T>(10), slope<T>(40, 70), T(50000)};
    const auto seen = [&](HalfLit lit) {
        return single_scattering_marched<T, DefaultScene>(earth<T>(), view.eye, view.direction, view.to_sun,
                                                          view.distance, 64, lit);
    };
    const Scattered<T> whole = march<DefaultScene>(earth<T>(), view, 64);
    const Scattered<T> near = seen(HalfLit{25000.0, true});
    const Scattered<T> far = seen(HalfLit{25000.0, false});
    for (int i = 0; i < 3; ++i) {
        CHECK(near.radiance[i] > T(0));
        CHECK(far.radiance[i] > T(0));
        CHECK(near.transmittance[i] == whole.transmittance[i]);
        // 64 terms of one sign, summed in two ways.
        CHECK_WITHIN(
            compare_roundoffs("single_scattering_marched.radiance", {{"channel", T(i)}},
                              near.radiance[i] + far.radiance[i], whole.radiance[i], whole.radiance[i]),
            64.0L);
    }
}

TEST_CASE_TEMPLATE(
    "the hook is asked once per step, at the midpoints of the ray in the air, relative to the eye", T, float,
    double, long double) {
    std::vector<vec3<T>> positions;
    const vec3<T> down = vec3<T>(T(0), T(0), T(-1));
    const T outside = T(300e3L);
    const Scattered<T> seen = single_scattering_marched<T, DefaultScene>(
        earth<T>(), standing(outside), down, slope<T>(50), no_surface<T>(), 10, Recorder<T>{&positions});
    CHECK(seen.radiance.x > T(0));
    REQUIRE(positions.size() == 10);
    for (int i = 0; i < 10; ++i) {
        const vec3<T> p = positions[static_cast<std::size_t>(i)];
        // 200 km to the air, then 100 km of it in ten steps. The entry is good to 4 ulp, the sum rounds
        // again.
        CHECK_WITHIN(compare_ulp("position.z", {{"step", T(i)}}, p.z, -(205e3L + 10e3L * i)), 6.0L);
        CHECK(p.x == T(0));  // exact: the direction's components times a number
        CHECK(p.y == T(0));
    }
}

TEST_CASE_TEMPLATE("no way, no air, no sunlight lost: radiance 0, transmittance 1", T, float, double,
                   long double) {
    const auto check_clear = [](const Scattered<T>& seen) {
        CHECK(seen.radiance == vec3<T>(T(0)));  // as the docstring promises
        CHECK(seen.transmittance == vec3<T>(T(1)));
    };
    check_clear(
        march<DefaultScene>(earth<T>(), View<T>{standing(T(2)), slope<T>(30), slope<T>(40), T(0)}, 8));
    check_clear(march<DefaultScene>(
        earth<T>(), View<T>{standing(T(300e3L)), slope<T>(10), slope<T>(40), no_surface<T>()}, 8));
    check_clear(march<DefaultScene>(earth<T>(),
                                    View<T>{standing(T(300e3L)), slope<T>(-90), slope<T>(40), T(100e3L)}, 8));
    check_clear(march<DefaultScene>(
        earth<T>(), View<T>{standing(T(0)), slope<T>(-30), slope<T>(40), no_surface<T>()}, 8));
    const Atmosphere<T> vacuum = airless(earth<T>());
    check_clear(
        march<DefaultScene>(vacuum, View<T>{standing(T(2)), slope<T>(30), slope<T>(40), no_surface<T>()}, 8));
}

TEST_CASE_TEMPLATE("an eye below the ground sees what an eye standing on it sees", T, float, double,
                   long double) {
    // Our reading where sources clamp the height in one place and mirror it in another.
    for (const T depth : {T(1e-3L), T(100), T(1e5L), earth<T>().ground_radius}) {
        for (const double elevation : {90.0, 20.0, 1.0}) {
            for (const vec3<T>& sun : {slope<T>(50, 20), slope<T>(2, 100), slope<T>(-4)}) {
                const View<T> below = {standing(-depth), slope<T>(elevation), sun, no_surface<T>()};
                const View<T> on = {standing(T(0)), slope<T>(elevation), sun, no_surface<T>()};
                // Exact: the same altitude after clamping.
                check_same(march<DefaultScene>(earth<T>(), below, 8), march<DefaultScene>(earth<T>(), on, 8));
            }
        }
    }
}

TEST_CASE_TEMPLATE("the sky changes smoothly where the eye leaves the air", T, float, double, long double) {
    const T top = earth<T>().top_altitude;
    const vec3<T> down = slope<T>(-60);
    const Scattered<T> inside = single_scattering_marched<T>(earth<T>(), standing(top * T(0.99999L)), down,
                                                             slope<T>(40), no_surface<T>(), 64);
    const Scattered<T> outside = single_scattering_marched<T>(earth<T>(), standing(top * T(1.00001L)), down,
                                                              slope<T>(40), no_surface<T>(), 64);
    for (int i = 0; i < 3; ++i) {
        // 1 m of 115 km moves the samples by 1e-5 of a step of 1.8 km: 1e-5 times the density's change per
        // step, 0.22.
        CHECK_WITHIN(compare_relative("single_scattering_marched.radiance", {}, outside.radiance[i],
                                      inside.radiance[i]),
                     3e-5L);
        CHECK_WITHIN(compare_relative("single_scattering_marched.transmittance", {}, outside.transmittance[i],
                                      inside.transmittance[i]),
                     3e-5L);
    }
}

TEST_CASE(
    "with many steps the march converges to the adaptive quadrature, at second order away from shadow "
    "edges") {
    std::printf(
        "single scattering against the table, largest error of three channels (radiance, transmittance)\n");
    std::printf("%-18s %10s %10s %10s %6s   %10s\n", "view", "32 steps", "128", "512", "order", "T at 512");
    double noon[3] = {0, 0, 0};
    int regular = 0;
    for (const Row& row : reference("single_scattering")) {
        const View<double> view = table_view<double>(row);
        const Scattered<double> results[] = {march<DefaultScene>(table_air<double>(), view, 32),
                                             march<DefaultScene>(table_air<double>(), view, 128),
                                             march<DefaultScene>(table_air<double>(), view, 512)};
        double errors[3] = {0, 0, 0};
        double transmittance_error = 0;
        for (int k = 0; k < 3; ++k) {
            const double expected = static_cast<double>(row.expected("r" + std::to_string(k)));
            if (row.text("view") == "noon_zenith") {
                noon[k] = expected;
            }
            // Relative, but no smaller than to 1e-4 of the zenith at noon.
            const double scale = std::max(expected, 1e-4 * noon[k]);
            for (int i = 0; i < 3; ++i) {
                errors[i] = std::max(errors[i], std::fabs(results[i].radiance[k] - expected) / scale);
            }
            const double t = static_cast<double>(row.expected("t" + std::to_string(k)));
            transmittance_error = std::max(transmittance_error, std::fabs(results[2].transmittance[k] - t));
        }
        const double order =
            errors[2] > 0 ? convergence_order(errors[1], errors[2]) / 2 : 0.0;  // per doubling
        std::printf("%-18s %10.2e %10.2e %10.2e %6.2f   %10.2e\n", row.text("view").c_str(), errors[0],
                    errors[1], errors[2], order, transmittance_error);
        CAPTURE(row.text("view"));
        const bool edge = crosses_shadow(row.text("view"));
        // Midpoint rule, 512 steps: h^2 / 24 H^2 with steps of 2.2 km along the horizon and 0.2 to 1 km
        // elsewhere.
        CHECK(errors[2] <= (edge ? 2e-2 : 2e-3));
        CHECK(transmittance_error <= 1e-3);
        if (!edge && errors[2] > 1e-6) {
            CHECK(order > 1.7);
            ++regular;
        }
        if (edge) {
            // First order where sunlight begins: a step of up to 1 / 8192 of the ray is lit or dark by
            // mistake, in which a few times the mean light may stand.
            const Scattered<double> finest = march<DefaultScene>(table_air<double>(), view, 8192);
            for (int k = 0; k < 3; ++k) {
                const double expected = static_cast<double>(row.expected("r" + std::to_string(k)));
                CHECK(std::fabs(finest.radiance[k] - expected) <=
                      8.0 / 8192 * std::max(expected, 1e-4 * noon[k]));
            }
        }
    }
    CHECK(regular >= 12);
}

TEST_CASE_TEMPLATE("all types see the table's views alike", T, float, double) {
    Worst worst;
    for (const Row& row : reference("single_scattering")) {
        if (crosses_shadow(row.text("view"))) {
            continue;  // one sample at the edge may be lit for one type and dark for the other
        }
        const Scattered<T> got = march<DefaultScene>(table_air<T>(), table_view<T>(row), 64);
        const Scattered<long double> expected =
            march<DefaultScene>(table_air<long double>(), table_view<long double>(row), 64);
        for (int k = 0; k < 3; ++k) {
            // Altitudes are good to 3 roundoffs of themselves and of the way's drop, 1200 m turn them into
            // densities: 3 100 km / 1200 m = 250 roundoffs of the depth. The narrow aerosol lobe turns a
            // roundoff of the cosine into 3 g / (1 - g)^2 = 60; cosines of the sun near 0 move its column by
            // R / H = 800 roundoffs.
            const long double depth = -std::log(expected.transmittance[k]);
            const long double condition = expected.radiance[k] * (1 + 0.3L * (1 + depth)) * 800;
            worst.add(compare_roundoffs("single_scattering_marched.radiance",
                                        {{"altitude", table_view<T>(row).eye.altitude},
                                         {"dz", table_view<T>(row).direction.z},
                                         {"sz", table_view<T>(row).to_sun.z},
                                         {"channel", T(k)}},
                                        got.radiance[k], expected.radiance[k], condition));
            worst.add(compare_roundoffs("single_scattering_marched.transmittance",
                                        {{"altitude", table_view<T>(row).eye.altitude},
                                         {"dz", table_view<T>(row).direction.z},
                                         {"channel", T(k)}},
                                        got.transmittance[k], expected.transmittance[k],
                                        expected.transmittance[k] * (1 + depth) * 250));
        }
    }
    worst.print("against long double, 64 steps");
    CHECK_WORST(worst, 1.0L);
}

TEST_SUITE_END();
