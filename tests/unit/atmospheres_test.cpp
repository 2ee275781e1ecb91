#include <cmath>
#include <cstdio>
#include <initializer_list>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
void check_plausible(const Atmosphere<T>& planet) {
    CHECK(planet.ground_radius > T(1e6L));
    CHECK(planet.top_altitude > T(0));
    CHECK(planet.top_altitude < planet.ground_radius);
    CHECK(planet.rayleigh_scale_height > T(0));
    CHECK(planet.mie_scale_height > T(0));
    // Little air lies above the top: e^-9 at most.
    CHECK(planet.top_altitude >= 9 * planet.rayleigh_scale_height);
    CHECK(planet.mie_g > T(-1));
    CHECK(planet.mie_g < T(1));
    // A gas scatters blue more than green more than red.
    CHECK(planet.rayleigh_scattering.z > planet.rayleigh_scattering.y);
    CHECK(planet.rayleigh_scattering.y > planet.rayleigh_scattering.x);
    for (int i = 0; i < 3; ++i) {
        CHECK(planet.rayleigh_scattering[i] > T(0));
        CHECK(planet.mie_scattering[i] >= T(0));
        CHECK(planet.mie_absorption[i] >= T(0));
        CHECK(planet.ozone_absorption[i] >= T(0));
        CHECK(planet.ground_albedo[i] >= T(0));
        CHECK(planet.ground_albedo[i] <= T(1));
    }
}

void check_depth(const char* name, const vec3<double>& got, std::initializer_list<double> expected,
                 double tolerance) {
    std::printf("zenith optical depth of %s: %.4f %.4f %.4f\n", name, got.x, got.y, got.z);
    int i = 0;
    for (const double value : expected) {
        CAPTURE(std::string(name));
        CAPTURE(i);
        CHECK(std::fabs(got[i] - value) <= tolerance);
        ++i;
    }
}

}  // namespace

TEST_SUITE_BEGIN("atmospheres");

TEST_CASE_TEMPLATE("every preset is physically plausible", T, float, double, long double) {
    check_plausible(earth<T>());
    check_plausible(cs562_earth<T>());
    check_plausible(elek_earth<T>());
    check_plausible(leenman_earth<T>());
    check_plausible(mars<T>());
}

TEST_CASE("zenith optical depths by channel are scattering times scale height") {
    // By hand, coefficient times height, aerosol and ozone added. 2e-6: the air above the top is e^-12.5 of
    // the gas's 0.26, 1e-6; the closed form adds 3e-7 of that, the rounded 501.8 m below 4e-7.
    check_depth("earth", optical_depth<double>(earth<double>(), 0.0, 1.0, no_surface<double>()),
                {5.802e-3 * 8 + 4.44e-3 * 1.2 + 0.65e-3 * 15, 13.558e-3 * 8 + 4.44e-3 * 1.2 + 1.881e-3 * 15,
                 33.1e-3 * 8 + 4.44e-3 * 1.2 + 0.085e-3 * 15},
                2e-6);
    check_depth(
        "cs562_earth", optical_depth<double>(cs562_earth<double>(), 0.0, 1.0, no_surface<double>()),
        {5.8e-3 * 8 + 20e-3 / 0.9 * 1.2, 13.5e-3 * 8 + 20e-3 / 0.9 * 1.2, 33.1e-3 * 8 + 20e-3 / 0.9 * 1.2},
        2e-6);
    check_depth(
        "elek_earth", optical_depth<double>(elek_earth<double>(), 0.0, 1.0, no_surface<double>()),
        {6.55e-3 * 8 + 2e-3 / 0.9 * 1.2, 17.3e-3 * 8 + 2e-3 / 0.9 * 1.2, 23.0e-3 * 8 + 2e-3 / 0.9 * 1.2},
        2e-6);
    // The Lorentz curve times the Rayleigh density holds 501.8 m (tests/data/column.csv).
    check_depth("leenman_earth",
                optical_depth<double, Lorentzian>(leenman_earth<double>(), 0.0, 1.0, no_surface<double>()),
                {5.5e-3 * 8 + 21e-3 * 1.2 + 20.4e-6 * 501.8, 13.0e-3 * 8 + 21e-3 * 1.2 + 49.7e-6 * 501.8,
                 22.4e-3 * 8 + 21e-3 * 1.2 + 1.95e-6 * 501.8},
                2e-6);
    // Dust of 0.4437 at 550 nm, gas of 0.0026. 5e-5: the dust above 100 km is e^-9.26 of the most,
    // 0.463: 4.4e-5.
    check_depth("mars", optical_depth<double>(mars<double>(), 0.0, 1.0, no_surface<double>()),
                {42.86e-3 * 10.8 + 0.10006e-3 * 11.1, 41.08e-3 * 10.8 + 0.23379e-3 * 11.1,
                 39.29e-3 * 10.8 + 0.57078e-3 * 11.1},
                5e-5);
}

TEST_CASE_TEMPLATE("the published aerosols of Earth have a single-scattering albedo of 0.9, not 0.474", T,
                   float, double, long double) {
    // Our reading where two sources differ: extinction = scattering / 0.9.
    for (const Atmosphere<T>& planet : {earth<T>(), cs562_earth<T>(), elek_earth<T>()}) {
        for (int i = 0; i < 3; ++i) {
            const T albedo = planet.mie_scattering[i] / (planet.mie_scattering[i] + planet.mie_absorption[i]);
            CHECK_WITHIN(compare_ulp("single-scattering albedo", {}, albedo, 0.9L),
                         3.0L);  // two members, sum, quotient
        }
    }
}

TEST_CASE_TEMPLATE("Leenman's aerosol does not absorb, and absorption is a parameter of its own", T, float,
                   double, long double) {
    CHECK(leenman_earth<T>().mie_absorption == vec3<T>(T(0)));
    Atmosphere<T> hazy = leenman_earth<T>();
    hazy.mie_absorption = vec3<T>(T(1e-6L));
    CHECK(optical_depth(hazy, T(0), T(1), T(1000)).x >
          optical_depth(leenman_earth<T>(), T(0), T(1), T(1000)).x);
}

TEST_CASE_TEMPLATE("three Rayleigh triples are in circulation, each under its own name", T, float, double,
                   long double) {
    CHECK(cs562_earth<T>().rayleigh_scattering ==
          vec3<T>(T(5.8e-6L), T(13.5e-6L), T(33.1e-6L)));  // exact: the literals
    CHECK(elek_earth<T>().rayleigh_scattering == vec3<T>(T(6.55e-6L), T(17.3e-6L), T(23.0e-6L)));
    CHECK(leenman_earth<T>().rayleigh_scattering == vec3<T>(T(5.5e-6L), T(13.0e-6L), T(22.4e-6L)));
}

TEST_CASE_TEMPLATE("the presets hold the numbers that their sources print", T, float, double, long double) {
    // Exact: the literals. What a source leaves to its user is not here.
    const auto even = [](long double x) { return vec3<T>(T(x)); };
    const Atmosphere<T> cs562 = cs562_earth<T>();
    CHECK(cs562.mie_scattering == even(20e-6L));  // 0.02 per km
    CHECK(cs562.mie_g == T(0.76L));
    const Atmosphere<T> elek = elek_earth<T>();
    CHECK(elek.mie_scattering == even(2e-6L));
    CHECK(elek.rayleigh_scale_height == T(8000));
    CHECK(elek.mie_scale_height == T(1200));
    const Atmosphere<T> leenman = leenman_earth<T>();
    CHECK(leenman.ground_radius == T(6371e3L));
    CHECK(leenman.ground_radius + leenman.top_altitude == T(6471e3L));  // exact: below 2^24
    CHECK(leenman.mie_scattering == even(21e-6L));
    CHECK(leenman.mie_g == T(0.7L));
    CHECK(leenman.rayleigh_scale_height == T(8e3L));
    CHECK(leenman.mie_scale_height == T(1.2e3L));
    CHECK(leenman.ozone_absorption == vec3<T>(T(2.04e-5L), T(4.97e-5L), T(1.95e-6L)));
    CHECK(leenman.ozone_altitude == T(30e3L));
    CHECK(leenman.ozone_half_width == T(4e3L));
}

TEST_CASE("the default Earth's triple is 1.24062e-6 / m at 1 um, at 680, 550 and 440 nm") {
    const double wavelengths[] = {0.68, 0.55, 0.44};
    for (int i = 0; i < 3; ++i) {
        const double expected = 1.24062e-6 * angstrom_ratio(wavelengths[i], 1.0, 4.0);
        // 1e-4: half a unit of the fourth printed digit.
        CHECK_WITHIN(compare_relative("earth.rayleigh_scattering", {{"wavelength", wavelengths[i]}},
                                      earth<double>().rayleigh_scattering[i], expected),
                     1e-4L);
    }
}

TEST_CASE("the default Earth's ozone is 300 Dobson units: 2.687e20 per m^2 each, in a tent of 15 km") {
    const double peak_number_density = 300 * 2.687e20 / 15e3;
    const double cross_sections[] = {1.209e-25, 3.5e-25, 1.582e-26};  // m^2 at 680, 550, 440 nm
    for (int i = 0; i < 3; ++i) {
        // 0.002: half a unit of the last printed digit of 0.650, and 0.085 of two digits needs 0.006.
        CHECK_WITHIN(compare_relative("earth.ozone_absorption", {}, earth<double>().ozone_absorption[i],
                                      peak_number_density * cross_sections[i]),
                     i == 2 ? 0.006L : 0.002L);
    }
}

TEST_CASE("Mars' gas is that of its refractivity, density and King factor") {
    const double wavelengths[] = {0.68, 0.55, 0.44};
    for (int i = 0; i < 3; ++i) {
        const double per_um =
            rayleigh_coefficient(3.37e-6, 2.05e23 * 1e-18, wavelengths[i]) * king_factor(0.09);
        CHECK_WITHIN(compare_relative("mars.rayleigh_scattering", {{"wavelength", wavelengths[i]}},
                                      mars<double>().rayleigh_scattering[i], per_um * 1e6),
                     1e-4L);  // half a unit of the fifth printed digit
    }
}

TEST_SUITE_END();
