#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/sky.hpp>

#include "promises.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "views.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("sky");

TEST_CASE_TEMPLATE("without air the sky is black, and the sun as bright as above it", T, float, double) {
    const vec3<T> sun = slope<T>(30);
    const SunDisc<T> disc = solar_disc<T>();
    // Exact: nothing scatters, and exp(0) of the disc passes.
    CHECK(sky_radiance(airless(earth<T>()), standing(T(2)), sun, sun, disc) == sun_radiance(disc, sun, sun));
    CHECK(sky_radiance(airless(earth<T>()), standing(T(2)), slope<T>(35), sun, disc) == vec3<T>(T(0)));
}

TEST_CASE_TEMPLATE("beside the sun the sky is the air's light, in front of it the disc is added", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const SunDisc<T> disc = solar_disc<T>();
    Random random(331);
    for (int i = 0; i < 300; ++i) {
        const Viewpoint<T> eye = {T(random.log_uniform(1, 1e8)), random.direction<T>()};
        const vec3<T> direction = random.direction<T>();
        const Scattered<T> light = single_scattering(air, eye, direction, -direction, no_surface<T>());
        // Exact: the same call.
        CHECK(sky_radiance(air, eye, direction, -direction, disc) == light.radiance);
        const Scattered<T> towards = single_scattering(air, eye, direction, direction, no_surface<T>());
        const vec3<T> seen = sky_radiance(air, eye, direction, direction, disc);
        if (air_ray(air, eye, direction, no_surface<T>()).reaches_ground) {
            CHECK(seen == towards.radiance);  // the sun is behind the planet
        } else {
            CHECK(seen ==
                  towards.radiance + sun_radiance(disc, direction, direction) * towards.transmittance);
        }
    }
}

TEST_CASE_TEMPLATE("a table's light, or a march's, gets the same sun", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const vec3<T> sun = slope<T>(17);
    const Scattered<T> marched =
        single_scattering_marched(air, standing(T(2)), sun, sun, no_surface<T>(), 16);
    const vec3<T> seen = sky_with_sun(air, standing(T(2)), sun, sun, solar_disc<T>(), marched);
    // Exact: the same sum.
    CHECK(seen == marched.radiance + sun_radiance(solar_disc<T>(), sun, sun) * marched.transmittance);
}

TEST_CASE("what the disc's pixels send is what sunlight says, at noon, in dusk and half set") {
    // Two ways that share no formula but the transmittance: pixels added up, and the visible share of a disc.
    const Atmosphere<double> air = earth<double>();
    SunDisc<double> disc = solar_disc<double>();
    disc.limb_exponents = vec3<double>(0);  // sunlight takes an even disc
    for (const double altitude : {0.0, 3000.0}) {
        const double horizon = -std::acos(air.ground_radius / (air.ground_radius + altitude));
        for (const double elevation : {1.2, 0.2, horizon + 0.01, horizon, horizon - 0.003}) {
            const vec3<double> to_sun = slope<double>(elevation * 57.295779513082321);
            const vec3<double> up(-to_sun.z, 0, to_sun.x);
            const vec3<double> across(0, 1, 0);
            vec3<double> sum(0);
            const int side = 60;
            const double step = 2 * disc.sin_radius / side;
            for (int j = 0; j < side * side; ++j) {
                const double x = -disc.sin_radius + (j % side + 0.5) * step;
                const double y = -disc.sin_radius + (j / side + 0.5) * step;
                const vec3<double> direction = x * across + y * up + std::sqrt(1 - x * x - y * y) * to_sun;
                const vec3<double> dark(0);
                // The transmittance alone, so that the disc is all there is.
                const Scattered<double> through = {
                    dark, transmittance(air, altitude, direction.z, no_surface<double>())};
                // A pixel's irradiance of a surface that faces the sun: its solid angle times the cosine is
                // step^2.
                sum += step * step * sky_with_sun(air, standing(altitude), direction, to_sun, disc, through);
            }
            const vec3<double> expected = sunlight(air, altitude, to_sun.z, disc.sin_radius);
            for (int k = 0; k < 3; ++k) {
                Comparison compared = compare_relative(
                    "sky_with_sun",
                    {{"altitude", altitude}, {"elevation", elevation}, {"channel", double(k)}}, sum[k],
                    expected[k]);
                compared.error *= expected[k];  // of full sunlight
                // The docstring of sunlight, and the pixels' stair steps at the rim, 1 / 60 of the radius.
                CHECK_WITHIN(compared, 0.0015L + 0.005L * expected[k]);
            }
        }
    }
}

TEST_CASE_TEMPLATE("the sky is an amount everywhere", T, float, double) {
    Random random(332);
    const Atmosphere<T> worlds[] = {earth<T>(), leenman_earth<T>(), mars<T>(), airless(earth<T>())};
    for (int i = 0; i < 4000; ++i) {
        const Atmosphere<T>& air = worlds[i % 4];
        const Viewpoint<T> eye = {T(random.log_uniform(1, 1e9)) - T(10), random.direction<T>()};
        const vec3<T> to_sun = random.direction<T>();
        SunDisc<T> disc = solar_disc<T>();
        disc.sin_edge = T(random.below(2)) * T(random.log_uniform(1e-6, 1));
        const vec3<T> near_sun = to_sun + T(random.log_uniform(1e-7, 1)) * random.direction<T>();
        const vec3<T> direction = near_sun / std::sqrt(dot_product(near_sun, near_sun));
        CHECK(is_amount(sky_radiance(air, eye, direction, to_sun, disc)));
        CHECK(is_amount(sky_radiance(air, eye, to_sun, to_sun, disc)));
    }
}

TEST_SUITE_END();
