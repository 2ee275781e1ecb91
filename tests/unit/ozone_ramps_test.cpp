#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/ozone_ramps.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// The density that the ramps stand for, in the arithmetic of T.
template <typename T>
T density_of(const Ramps<T>& ramps, T ground_radius, T altitude) {
    const auto three = [&](const vec3<T>& weights, const vec3<T>& altitudes) {
        T sum = 0;
        for (int k = 0; k < 3; ++k) {
            const T over = altitudes[k] - altitude;
            sum += weights[k] * std::max(over * (2 * ground_radius + altitudes[k] + altitude), T(0));
        }
        return sum;
    };
    return three(ramps.weights.first, ramps.altitudes.first) +
           three(ramps.weights.second, ramps.altitudes.second) +
           three(ramps.weights.third, ramps.altitudes.third) +
           three(ramps.weights.fourth, ramps.altitudes.fourth);
}

}  // namespace

TEST_SUITE_BEGIN("ozone_ramps");

TEST_CASE("a tent's ramps stay close to the tent, and either side holds what the tent's side holds") {
    const Atmosphere<double> air = earth<double>();
    const Ramps<double> ramps = tent_ramps(air);
    const double step = 10;
    double worst = 0;
    double below = 0;
    double above = 0;
    for (double altitude = 0.5 * step; altitude <= 6e4; altitude += step) {
        const double expected = tent_density(altitude, air.ozone_altitude, air.ozone_half_width);
        const double off = density_of(ramps, air.ground_radius, altitude) - expected;
        worst = std::fmax(worst, std::fabs(off));
        (altitude < air.ozone_altitude ? below : above) += off * step;
    }
    std::printf("tent as ramps: density off by %.1e of the peak, its sides by %.1e and %.1e of theirs\n",
                worst, below / (air.ozone_half_width / 2), above / (air.ozone_half_width / 2));
    // A straight line in r^2 is off by t (1 - t) half width / (2 radius), of which the mean is taken off:
    // half width over 12 radii at the shells.
    CHECK(worst <= air.ozone_half_width / (12 * air.ground_radius));
    CHECK(worst >= 1e-4);  // it is a different curve: this check can see that
    CHECK(std::fabs(below) <= 1e-6 * air.ozone_half_width);  // the next order of half width over the radius
    CHECK(std::fabs(above) <= 1e-6 * air.ozone_half_width);
}

TEST_CASE("a Lorentz curve's ramps never go below zero, end at their ceiling, and hold the whole layer") {
    Random random(651);
    for (int i = 0; i < 500; ++i) {
        Atmosphere<double> air = leenman_earth<double>();
        if (i > 0) {
            air.ozone_altitude = random.uniform(0, 5e4);
            air.ozone_half_width = random.log_uniform(10, 1e5);
            air.rayleigh_scale_height = random.log_uniform(100, 1e5);
        }
        const Ramps<double> ramps = lorentzian_ramps(air);
        double peak = 0;
        double lowest = 0;
        for (double share = 0; share <= 1; share += 1.0 / 512) {
            const double density = density_of(ramps, air.ground_radius, share * ramps.ceiling);
            peak = std::fmax(peak, density);
            lowest = std::fmin(lowest, density);
        }
        CAPTURE(air.ozone_altitude);
        CAPTURE(air.ozone_half_width);
        CAPTURE(air.rayleigh_scale_height);
        CHECK(peak > 0);
        CHECK(lowest >= -1e-9 * peak);  // roundoff of weights whose sum is thousands of times the density
        CHECK(density_of(ramps, air.ground_radius, ramps.ceiling) == 0);
        CHECK(density_of(ramps, air.ground_radius, 2 * ramps.ceiling) == 0);
    }
}

TEST_CASE_TEMPLATE(
    "a Lorentz curve far above all molecules leaves their tail near the ground, and no infinity", T, float,
    double, long double) {
    for (const T height : {T(0), T(1e-3L), T(10), T(500)}) {
        Atmosphere<T> air = leenman_earth<T>();
        air.ground_radius = T(5060);
        air.ozone_altitude = T(270e3);
        air.ozone_half_width = T(73e3);
        air.rayleigh_scale_height = height;
        const Ramps<T> ramps = lorentzian_ramps(air);
        const T ground = density_of(ramps, air.ground_radius, T(0));
        CAPTURE(height);
        CHECK(std::isfinite(ground));
        // The curve at the ground is 0.068; 1.6 times that at most, where a straight line stands for its
        // tail.
        CHECK(ground <= T(0.11L));
        CHECK(ground >= T(0));
        CHECK(density_of(ramps, air.ground_radius, 12 * height + T(1)) <=
              T(1e-3L));  // e^-12, and what is no layer
    }
}

TEST_CASE_TEMPLATE("ozone is the same from both ends, adds up, and none is none", T, float, double,
                   long double) {
    Random random(652);
    for (int i = 0; i < 2000; ++i) {
        const Atmosphere<T> air = leenman_earth<T>();
        const Ramps<T> ramps = ozone_ramps<T, Lorentzian>(air);
        const T perigee_altitude = T(random.uniform(0, 8e4));
        const Shells<T> shells = shells_along<T, Lorentzian>(ramps, air.ground_radius, perigee_altitude);
        const T a = T(random.uniform(-1e6, 1e6));
        const T whole = ozone_beyond<T, Lorentzian>(ramps, shells, T(-1e12L));
        const T from_a = ozone_beyond<T, Lorentzian>(ramps, shells, a);
        const T from_mirror = ozone_beyond<T, Lorentzian>(ramps, shells, -a);
        const T largest = T(7e4);  // [m], about the largest column that Leenman's curve has
        // What is before a equals what is beyond -a; ramps reach 1e3 times their sum.
        const T rounding = 1000 * std::numeric_limits<T>::epsilon() * largest;
        CHECK(std::fabs(whole - from_a - from_mirror) <= rounding);
        CHECK(from_a >= T(0));
        CHECK(from_a <= whole + rounding);
        CHECK(ozone_beyond<T, Lorentzian>(ramps, shells, shells.fourth.z) == T(0));
        CHECK(ozone_beyond<T, NoOzone>(ozone_ramps<T, NoOzone>(air),
                                       shells_along<T, NoOzone>(ramps, air.ground_radius, perigee_altitude),
                                       a) == T(0));
    }
}

TEST_CASE_TEMPLATE("a layer of zero width has no weight, in either shape", T, float, double, long double) {
    Atmosphere<T> air = earth<T>();
    air.ozone_half_width = T(0);
    for (const Ramps<T>& ramps : {tent_ramps(air), lorentzian_ramps(air)}) {
        for (const vec3<T>& weights :
             {ramps.weights.first, ramps.weights.second, ramps.weights.third, ramps.weights.fourth}) {
            CHECK(weights == vec3<T>(T(0), T(0), T(0)));
        }
    }
}

TEST_SUITE_END();
