#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/habitat_irradiance.hpp>
#include <airlight/habitat_scattering.hpp>
#include <airlight/habitats.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// A habitat of the same make whose radius and strips are someone else's.
template <typename T>
HabitatAir<T> smaller_air() {
    HabitatAir<T> air = rama_air<T>();
    air.radius = T(7500);
    air.density_rise = spun_density_rise(spin_for_gravity(air.radius, T(9.81L)), T(287.05L), T(288.15L));
    return air;
}

template <typename T>
HabitatLights<T> smaller_lights() {
    HabitatLights<T> lights = rama_lights<T>();
    lights.begin = T(5200);
    lights.end = T(16e3L);
    return lights;
}

HabitatAir<double> without_air(HabitatAir<double> air) {
    air.rayleigh_scattering = vec3<double>(0);
    air.mie_scattering = vec3<double>(0);
    air.mie_absorption = vec3<double>(0);
    return air;
}

/// What the wall and the caps of a habitat receive of its strips: power, and the wall's own mean.
struct Received {
    vec3<double> power;      ///< of wall and caps
    vec3<double> wall_mean;  ///< irradiance of the wall
};

/// By midpoints over a sixth of the turn, which stands for all: six are alike, and both halves are.
Received received(const HabitatAir<double>& air, const HabitatLights<double>& lights) {
    const int along = 96;
    const int around = 16;
    const double cell = air.radius * (pi<double> / 3 / around);
    vec3<double> wall(0);
    vec3<double> cap(0);
    for (int j = 0; j < around; ++j) {
        const double angle = (j + 0.5) / around * pi<double> / 3;
        const vec3<double> outward(0, std::cos(angle), std::sin(angle));
        for (int i = 0; i < along; ++i) {
            const vec3<double> x((i + 0.5) / along * lights.half_length, 0, 0);
            wall += cell * (lights.half_length / along) *
                    habitat_irradiance(air, lights, x + air.radius * outward, -outward, 2);
        }
        for (int i = 0; i < around; ++i) {
            const double from_axis = (i + 0.5) / around * air.radius;
            const vec3<double> place = vec3<double>(lights.half_length, 0, 0) + from_axis * outward;
            cap += cell * (from_axis / air.radius) * (air.radius / around) *
                   habitat_irradiance(air, lights, place, vec3<double>(-1, 0, 0), 2);
        }
    }
    const double sixth_of_half = 2 * pi<double> * air.radius * lights.half_length / 6;
    return {12.0 * (wall + cap), wall / sixth_of_half};
}

/// Power that six strips send, by Lambert's law pi times radiance times area.
double sent(const HabitatLights<double>& lights) {
    return 6 * pi<double> * lights.radiance.y * lights.width * (lights.end - lights.begin);
}

}  // namespace

TEST_SUITE_BEGIN("habitats");

TEST_CASE_TEMPLATE("the habitat of Rama is what its document prints, with the air of Earth", T, float, double,
                   long double) {
    const HabitatAir<T> air = rama_air<T>();
    const Atmosphere<T> planet = earth<T>();
    CHECK(air.radius == T(8000));  // exact, as are the coefficients: the same literals
    CHECK(air.rayleigh_scattering == planet.rayleigh_scattering);
    CHECK(air.mie_scattering == planet.mie_scattering);
    CHECK(air.mie_absorption == planet.mie_absorption);
    CHECK(air.mie_g == planet.mie_g);
    // k R^2 = g R / (2 R_s T), by hand; the wall weighs as much as the ground.
    CHECK(double(air.density_rise * air.radius * air.radius) ==
          doctest::Approx(9.81 * 8000 / (2 * 287.05 * 288.15)).epsilon(1e-6));  // float's roundoffs
    const HabitatLights<T> lights = rama_lights<T>();
    CHECK(lights.half_length == T(24000));  // exact: whole numbers
    CHECK(lights.begin == T(5000));
    CHECK(lights.end == T(16000));
    CHECK(lights.width == T(100));
    CHECK(lights.fine == T(200));
    CHECK(T(48) * lights.fine_share == T(4));  // two texels of 48 on both sides; exact: 1 / 12 times 48
    CHECK(lights.radiance == vec3<T>(T(1)));
}

TEST_CASE("without air all that the strips send comes to the wall and the caps") {
    for (const bool other : {false, true}) {
        const HabitatAir<double> air = without_air(other ? smaller_air<double>() : rama_air<double>());
        const HabitatLights<double> lights = other ? smaller_lights<double>() : rama_lights<double>();
        const Received all = received(air, lights);
        std::printf("radius %g m: %.6g of what is sent comes, without air\n", air.radius,
                    all.power.y / sent(lights));
        // Midpoints of a smooth light, as printed: 2e-4.
        CHECK(all.power.y == doctest::Approx(sent(lights)).epsilon(1e-3));
    }
}

TEST_CASE("the strips of Rama light the ground as the document has it when they are as bright as a lamp") {
    const HabitatAir<double> air = rama_air<double>();
    const HabitatLights<double> lights = rama_lights<double>();
    const vec3<double> bare = received(without_air(air), lights).wall_mean;
    const vec3<double> mean = received(air, lights).wall_mean;
    const double luminance = 35000 / mean.y;
    std::printf(
        "mean irradiance of the wall under radiance 1: %.5g sr without air, with air %.5g %.5g %.5g\n",
        bare.y, mean.x, mean.y, mean.z);
    std::printf("35 000 lux are a luminance of %.4g cd/m^2, %.4g without air\n", luminance, 35000 / bare.y);
    // Air only takes from the straight light, and of blue the most.
    CHECK(mean.x < bare.x);
    CHECK(mean.y < mean.x);
    CHECK(mean.z < mean.y);
    // Brighter than a fluorescent tube's 1e4 cd/m^2, less bright than the sun's 1.6e9: orders of magnitude.
    CHECK(luminance > 1e6);
    CHECK(luminance < 1e8);
    // All of the strips' power over wall and caps alike, by hand: 6 pi 11 km 100 m / (2 pi 8 km 48 km + 2 pi
    // (8 km)^2) = 7.37e-3. The wall beside the strips has more of it, the caps less.
    CHECK(bare.y > 6 * 11e3 * 100 / (2 * 8e3 * 48e3 + 2 * 8e3 * 8e3));
    CHECK(bare.y < 1.3 * 6 * 11e3 * 100 / (2 * 8e3 * 48e3 + 2 * 8e3 * 8e3));  // as printed: 1.1 times
}

TEST_CASE_TEMPLATE("radius and strips are only numbers: another habitat has places, light and lit walls", T,
                   float, double) {
    Random random(680);
    const HabitatAir<T> air = smaller_air<T>();
    const HabitatLights<T> lights = smaller_lights<T>();
    for (int i = 0; i < 2000; ++i) {
        const double x = random.uniform(0, 1);
        const double y = random.uniform(0, 0.99);
        const double z = random.uniform(0, 1);
        const vec3<T> unit = vec3<T>(T(x), T(y), T(z));
        const vec3<T> place = habitat_from_unit(air, lights, unit);
        const vec3<T> back = unit_from_habitat(air, lights, place);
        const double roundoff = double(std::numeric_limits<T>::epsilon());
        // As in the tests of habitat_mapping: the steepest stretch, the sine's series, the arc tangent's fit.
        CHECK(std::fabs(double(back.x - unit.x)) <= 16 * roundoff * 12);
        CHECK(std::fabs(double(back.y * back.y - unit.y * unit.y)) <=
              8 * roundoff + 1e-12);  // the sine's series
        CHECK(std::fabs(double(back.z * back.z - unit.z * unit.z)) <=
              32 * roundoff + 6e-8);  // the arc tangent's fit
        const vec3<T> light = habitat_bare_radiance(air, lights, place);
        const vec3<T> passed = habitat_mean_passed(air, lights, place, 1);
        CHECK(light.x > T(0));
        CHECK(light.x < T(1));  // a mean of what is 1 or 0
        CHECK(passed.z > T(0));
        CHECK(passed.z < passed.x);
        CHECK(passed.x < T(1));
        const vec3<T> lit = habitat_irradiance(air, lights, place, habitat_strip(air, lights, 0).normal, 1);
        CHECK(lit.y > T(0));
        CHECK(lit.y < pi<T>);
    }
}

TEST_SUITE_END();
