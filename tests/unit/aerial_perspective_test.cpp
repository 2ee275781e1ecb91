#include <cmath>

#include <doctest/doctest.h>
#include <airlight/aerial_perspective.hpp>
#include <airlight/atmospheres.hpp>
#include <airlight/sky.hpp>

#include "promises.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "views.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("aerial_perspective");

TEST_CASE_TEMPLATE("a surface at no distance is seen as it is, far away it fades into the sky", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const vec3<T> surface(T(0.1L), T(0.02L), T(0.3L));
    const vec3<T> sun = slope<T>(40);
    const vec3<T> level = slope<T>(0.6);
    CHECK(aerial_perspective(air, standing(T(2)), level, sun, T(0), surface) == surface);  // exact: no air
    const vec3<T> sky = sky_radiance(air, standing(T(2)), level, sun, solar_disc<T>());
    T before = T(1);
    for (const T distance : {T(1e3L), T(1e4L), T(1e5L), T(1e6L)}) {
        const vec3<T> seen = aerial_perspective(air, standing(T(2)), level, sun, distance, surface);
        const T left = std::fabs(seen.z - sky.z);
        CHECK(left < before);
        before = left;
    }
    // Of the surface 4e-4 is left: some 24 air masses, each of a blue depth of 0.27 and haze besides.
    CHECK(before < T(1e-3L) * surface.z);
}

TEST_CASE_TEMPLATE("a kilometre of haze of visibility 5 km leaves 2 % to the power of a fifth", T, float,
                   double, long double) {
    // exp(-3.912 / 5) = 0.4573, Koschmieder's law.
    Atmosphere<T> air = cs562_earth<T>();
    air.rayleigh_scattering = vec3<T>(T(0));
    air.mie_scale_height = T(1e7L);  // even along a level ray
    air.mie_scattering = vec3<T>(T(0.9L) * T(3.912e-3L) / 5);
    air.mie_absorption = vec3<T>(T(0.1L) * T(3.912e-3L) / 5);
    const vec3<T> night = slope<T>(-70);
    const vec3<T> seen = aerial_perspective(air, standing(T(2)), slope<T>(0), night, T(1000), vec3<T>(T(1)));
    CHECK_WITHIN(compare_relative("aerial_perspective", {}, seen.y, 0.4573L),
                 2e-4L);  // the digits written here, and density's fall of 1e-4 over the ray
}

TEST_CASE_TEMPLATE("air in two parts is the air in one", T, double) {
    // Dimmed by the far part, then by the near one, with both parts' light: the nodes' error is all that
    // differs.
    const Atmosphere<T> air = earth<T>();
    const vec3<T> surface(T(0.05L));
    const vec3<T> sun = slope<T>(23);
    Random random(341);
    for (int i = 0; i < 200; ++i) {
        const Viewpoint<T> eye = standing(T(random.log_uniform(1, 1e4)));
        const vec3<T> direction = slope<T>(random.uniform(-0.05, 80));
        const T whole = T(random.log_uniform(1e3, 1e5));
        const T first = whole * T(random.uniform(0.1, 0.9));
        if (air_ray(air, eye, direction, whole).reaches_ground) {
            continue;
        }
        const Viewpoint<T> between =
            viewpoint_from_surface(air.ground_radius, eye.altitude * eye.up + first * direction, eye.up);
        const vec3<T> beyond = aerial_perspective(air, between, direction, sun, whole - first, surface);
        const vec3<T> parts = aerial_perspective(air, eye, direction, sun, first, beyond);
        const vec3<T> once = aerial_perspective(air, eye, direction, sun, whole, surface);
        for (int k = 0; k < 3; ++k) {
            CHECK_WITHIN(compare_relative("aerial_perspective", {{"whole", whole}, {"first", first}},
                                          parts[k], static_cast<long double>(once[k])),
                         1e-3L);  // eight nodes by day, docs/trade.md
        }
    }
}

TEST_CASE_TEMPLATE("haze in front of a near wall hardly glows, and as Leenman has it not at all", T, double) {
    const Atmosphere<T> air = leenman_earth<T>();
    const Atmosphere<T> dark = without_aerosol_glow(air);
    const vec3<T> sun = slope<T>(3);
    const vec3<T> towards = slope<T>(2);
    const auto light = [&](const Atmosphere<T>& world, T distance) {
        return single_scattering<T, Lorentzian>(world, standing(T(2)), towards, sun, distance);
    };
    const Scattered<T> sky = light(air, no_surface<T>());
    const Scattered<T> wall = light(air, T(50));
    // 50 m of haze in front of the horizon, which is 20 km of it thick and more.
    CHECK(wall.radiance.y < T(0.01L) * sky.radiance.y);
    for (const T distance : {T(50), T(5e3L), T(1e5L), no_surface<T>()}) {
        const Scattered<T> glowing = light(air, distance);
        const Scattered<T> glowless = light(dark, distance);
        // The same light is taken; sums of two numbers in another order.
        CHECK_WITHIN(compare_ulp("transmittance", {{"distance", distance}}, glowless.transmittance.y,
                                 static_cast<long double>(glowing.transmittance.y)),
                     64.0L);
        CHECK(glowless.radiance.y < glowing.radiance.y);
        // What is gone is in proportion to the aerosol's phase function, and so is all of it.
        Atmosphere<T> narrow = air;
        narrow.mie_g = T(0.3L);
        const Scattered<T> other = light(narrow, distance);
        const T cosine = dot_product(towards, sun);
        const long double ratio =
            static_cast<long double>(mie_phase(cosine, air.mie_g)) / mie_phase(cosine, narrow.mie_g);
        CHECK_WITHIN(
            compare_relative(
                "glow", {{"distance", distance}},
                (glowing.radiance.y - glowless.radiance.y) / (other.radiance.y - glowless.radiance.y), ratio),
            1e-9L);  // the same nodes; rounding, of differences a few per cent of their terms
    }
}

TEST_CASE_TEMPLATE("the sun lights what faces it, and less as it sets", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const T radius = solar_sin_radius<T>;
    const vec3<T> up(T(0), T(0), T(1));
    // Overhead: what passes straight down; exact, facing is 1.
    CHECK(sun_irradiance(air, standing(T(0)), up, up, radius) == sunlight(air, T(0), T(1), radius));
    CHECK(sun_irradiance(air, standing(T(0)), -up, up, radius) == vec3<T>(T(0)));
    T before = T(1);
    for (int i = 0; i <= 100; ++i) {
        const vec3<T> sun = slope<T>(17.0 - 0.18 * i);
        const T wall = sun_irradiance(air, standing(T(0)), slope<T>(0), sun, radius).x;
        CHECK(wall <= before);
        before = wall;
    }
    CHECK(before == T(0));  // the last of the disc is below the horizon at -0.27 degrees
}

TEST_CASE_TEMPLATE("what is seen is an amount, whatever the distance", T, float, double) {
    Random random(342);
    const Atmosphere<T> worlds[] = {earth<T>(), leenman_earth<T>(), mars<T>(),
                                    without_aerosol_glow(earth<T>())};
    for (int i = 0; i < 4000; ++i) {
        const Atmosphere<T>& air = worlds[i % 4];
        const Viewpoint<T> eye = {T(random.log_uniform(1, 1e9)) - T(10), random.direction<T>()};
        const T distance = random.below(5) == 0 ? no_surface<T>() : T(random.log_uniform(1e-3, 1e9));
        const vec3<T> surface = vec3<T>(T(random.log_uniform(1e-6, 1e6)));
        CHECK(is_amount(
            aerial_perspective(air, eye, random.direction<T>(), random.direction<T>(), distance, surface)));
        CHECK(is_share(
            sun_irradiance(air, eye, random.direction<T>(), random.direction<T>(), T(random.unit()))));
    }
}

TEST_SUITE_END();
