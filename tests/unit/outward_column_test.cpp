#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/outward_column.hpp>
#include <airlight/sun_column.hpp>
#include <airlight/transmittance.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// A straight line through the air, by its closest approach and a point on it.
struct Line {
    double perigee_altitude;
    double altitude;
};

Line random_line(Random& random) {
    const double altitude = random.below(3) == 0 ? random.uniform(0.0, 9e4) : random.log_uniform(1.0, 9e4);
    const double perigee = random.below(3) == 0 ? altitude : altitude - random.log_uniform(1.0, 6e6);
    return Line{perigee, altitude};
}

template <typename T>
LinePoint<T> point_on(const Atmosphere<T>& air, const Line& line) {
    const long double perigee = static_cast<long double>(air.ground_radius) + line.perigee_altitude;
    const long double radius = static_cast<long double>(air.ground_radius) + line.altitude;
    const T along = T(std::sqrt((radius - perigee) * (radius + perigee)));
    return line_point(T(line.altitude), T(radius), T(1 / radius), along, T(perigee),
                      T(line.perigee_altitude));
}

/// The accurate closed forms of column.hpp for the same line, up to the top.
template <typename Scene>
Column<long double> accurate(const Atmosphere<long double>& air, const Line& line) {
    const long double perigee = air.ground_radius + line.perigee_altitude;
    const long double radius = air.ground_radius + line.altitude;
    const long double mu = std::sqrt((radius - perigee) * (radius + perigee)) / radius;
    return column_to_space<long double, Scene>(air, static_cast<long double>(line.altitude), mu);
}

template <typename T, typename Scene>
Column<T> outwards(const Atmosphere<T>& air, const Line& line) {
    const Layers<T> layers = layers_of<T, Scene>(air);
    const LinePoint<T> point = point_on(air, line);
    const Shells<T> shells =
        shells_along<T, Scene>(layers.ozone, air.ground_radius, T(line.perigee_altitude));
    return column_outwards<T, Scene>(layers, point, shells,
                                     layer_density<T, Scene>(layers, T(line.altitude)));
}

/// Air whose top is so high that nothing lies above it.
template <typename T>
Atmosphere<T> endless(Atmosphere<T> air) {
    air.top_altitude = T(4e5);
    return air;
}

}  // namespace

TEST_SUITE_BEGIN("outward_column");

TEST_CASE_TEMPLATE("straight up the air is density times scale height", T, float, double, long double) {
    const Atmosphere<T> air = earth<T>();
    const Layers<T> layers = layers_of(air);
    for (const T altitude : {T(0), T(1e3), T(2e4)}) {
        const LinePoint<T> point =
            line_point(altitude, air.ground_radius + altitude, T(1) / (air.ground_radius + altitude),
                       air.ground_radius + altitude, T(0), -air.ground_radius);
        const T got = exponential_outwards(point, T(0.5), layers.rayleigh_height, layers.rayleigh_root);
        // First order of Chapman's function at radius over height 800: 3e-6.
        CHECK_WITHIN(compare_relative("exponential_outwards", {{"altitude", altitude}}, got, 4e3L), 3e-6L);
    }
}

TEST_CASE_TEMPLATE("Chapman's function to first order keeps the errors that it states, against 50 digits", T,
                   double, long double) {
    Worst x_50;
    Worst x_100;  // and 200
    Worst wide;   // x from 800 on
    Worst perigee_50;
    Worst perigee_wide;
    const T height = T(8000);
    const T root = T(1) / std::sqrt(height);
    for (const Row& row : reference("chapman")) {
        const T x = row.input<T>("x");
        if (row.text("function") != "chapman" || x < T(50)) {
            continue;  // a planet so small is outside what the docstrings state
        }
        const T mu = row.input<T>("mu");
        const T radius = x * height;
        const T along = radius * mu;
        const T perigee = std::sqrt((radius - along) * (radius + along));
        const LinePoint<T> point = line_point(T(0), radius, T(1) / radius, along, perigee, perigee - radius);
        const long double expected = static_cast<long double>(height) * row.expected("value");
        Worst& worst = x >= T(800) ? wide : x >= T(100) ? x_100 : x_50;
        worst.add(compare_relative("exponential_outwards", {{"x", x}, {"mu", mu}},
                                   exponential_outwards(point, T(0.5), height, root), expected / 2));
        if (mu == T(0)) {
            Worst& level = x >= T(800) ? perigee_wide : perigee_50;
            for (const T altitude : {T(0), T(16000)}) {
                level.add(
                    compare_relative("exponential_from_perigee", {{"x", x}, {"altitude", altitude}},
                                     exponential_from_perigee(radius, altitude, height),
                                     expected * std::exp(-static_cast<long double>(altitude / height))));
            }
        }
    }
    x_50.print("at radius / height = 50");
    x_100.print("at 100 and 200");
    wide.print("from 800 on");
    perigee_50.print("at x = 50, 100 and 200");
    perigee_wide.print("from x = 800 on");
    // What is left out of exponential_outwards, the second order, is up to 0.33 / x^2; the fit is 4e-8.
    CHECK_WORST(x_50, 1.3e-4L);   // docstring
    CHECK_WORST(x_100, 3.3e-5L);  // docstring, which rounds it to 3e-5
    CHECK_WORST(wide, 6e-7L);     // docstring
    // exponential_from_perigee leaves out 0.047 / x^2, by the series of the Bessel function K_1.
    CHECK_WORST(perigee_50, 2e-5L);    // docstring
    CHECK_WORST(perigee_wide, 1e-7L);  // docstring
}

TEST_CASE_TEMPLATE("molecules, aerosol and tent agree with the accurate closed forms", T, float, double) {
    Random random(631);
    const Atmosphere<T> air = endless(earth<T>());
    const Atmosphere<long double> exact_air = endless(earth<long double>());
    double rayleigh = 0;
    double mie = 0;
    double tent = 0;
    for (int i = 0; i < 20000; ++i) {
        const Line line = random_line(random);
        const Column<long double> expected = accurate<DefaultScene>(exact_air, line);
        const Column<T> got = outwards<T, DefaultScene>(air, line);
        rayleigh = std::fmax(rayleigh, std::fabs(static_cast<double>(got.rayleigh / expected.rayleigh - 1)));
        mie = std::fmax(
            mie, expected.mie > 1e-20L ? std::fabs(static_cast<double>(got.mie / expected.mie - 1)) : 0.0);
        // Against the largest column of all, level at the layer's lower end: 460 km.
        tent = std::fmax(tent, std::fabs(static_cast<double>(got.ozone - expected.ozone)) / 4.6e5);
    }
    std::printf("outwards, %s: Rayleigh %.1e, Mie %.1e relative; tent %.1e of its largest column\n",
                type_name<T>(), rayleigh, mie, tent);
    // First order of Chapman's function, 3e-6; in float a roundoff of 90 km over the scale height: 4e-6 at 8
    // km, 3e-5 at 1.2 km, and the altitude's own in exp.
    CHECK(rayleigh <= (sizeof(T) == 4 ? 2e-5 : 4e-6));
    CHECK(mie <= (sizeof(T) == 4 ? 6e-5 : 4e-6));
    // Straight in r^2, the tent's density is off by half width over 12 radii, 2e-4; columns average over it.
    CHECK(tent <= 2e-4);
}

TEST_CASE_TEMPLATE("the Lorentz curve's ramps follow the accurate closed form", T, float, double) {
    Random random(632);
    const Atmosphere<T> air = leenman_earth<T>();
    const Atmosphere<long double> exact_air = leenman_earth<long double>();
    // The level column just below the peak is about the largest above the ground.
    const long double largest = accurate<Lorentzian>(exact_air, Line{2.6e4, 2.6e4}).ozone;
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const Line line = random_line(random);
        const long double expected = accurate<Lorentzian>(exact_air, line).ozone;
        const T got = outwards<T, Lorentzian>(air, line).ozone;
        worst = std::fmax(worst, static_cast<double>(std::fabs(got - expected) / largest));
    }
    std::printf("Lorentz curve outwards, %s: %.1e of %.0Lf m\n", type_name<T>(), worst, largest);
    CHECK(worst <= 5e-3);  // twelve straight lines over the curve: the figure of lorentzian_ramps
}

TEST_CASE_TEMPLATE("a layer of no thickness holds nothing, and a thin one no infinity", T, float, double) {
    Atmosphere<T> air = earth<T>();
    air.rayleigh_scale_height = T(0);
    air.mie_scale_height = T(1e-3L);
    air.ozone_half_width = T(0);
    Random random(633);
    for (int i = 0; i < 1000; ++i) {
        const Line line = random_line(random);
        const Column<T> got = outwards<T, DefaultScene>(air, line);
        CHECK_UNARY(got.rayleigh >= T(0));
        CHECK_UNARY(got.rayleigh <= T(1e-20L));  // 1 m up, e^-150 of a layer of 6 mm
        CHECK_UNARY(got.mie >= T(0));
        CHECK_UNARY(got.ozone == T(0));
    }
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("sun_column");

TEST_CASE_TEMPLATE("an absorbing layer that reaches down to the planet's centre has a finite column", T,
                   float, double, long double) {
    Atmosphere<T> air = earth<T>();
    air.ground_radius = T(1e6);
    air.ozone_altitude = T(0);
    air.ozone_half_width = T(1e6);  // the low edge lies at the centre, exactly
    const Layers<T> layers = layers_of<T>(air);
    for (const T perigee_altitude : {T(-1e6), T(-1000), T(0), T(1000)}) {
        const Shells<T> shells = shells_along(layers.ozone, air.ground_radius, perigee_altitude);
        for (const T along : {T(0), T(1e3), T(1e6)}) {
            const T column = ozone_beyond(layers.ozone, shells, along);
            CHECK(std::isfinite(column));
            CHECK(column >= T(0));
        }
    }
}

TEST_CASE_TEMPLATE("the air to the sun is that of column_to_space, where it ends at the top too", T, float,
                   double) {
    // At 60 km 5e-4 of the Earth's air are still above, which a world that ends there does not have.
    Random random(641);
    for (const bool high_top : {true, false}) {
        Atmosphere<T> air = earth<T>();
        air.top_altitude = high_top ? air.top_altitude : T(60e3);
        const Layers<T> layers = layers_of(air);
        const vec3<T> extinction = air.mie_scattering + air.mie_absorption;
        double worst = 0;
        for (int i = 0; i < 20000; ++i) {
            const T altitude = T(random.uniform(0.0, 0.95 * static_cast<double>(air.top_altitude)));
            const T radius = air.ground_radius + altitude;
            const T height =
                radius * T(random.below(2) == 0 ? random.uniform(-1.0, 1.0) : random.uniform(-0.1, 0.1));
            const T mu = height / radius;
            if (behind_planet(air.ground_radius, altitude, mu)) {
                continue;
            }
            const LinePoint<T> point = line_towards_sun(altitude, radius, T(1) / radius, height);
            const Column<T> got = column_to_sun<T>(layers, air.ground_radius, point, height < T(0),
                                                   layer_density(layers, altitude));
            const Column<T> expected = column_to_space<T>(air, altitude, mu);
            // As light sees it: the share of light that the difference is worth.
            for (int k = 0; k < 3; ++k) {
                const auto depth = [&](const Column<T>& c) {
                    return air.rayleigh_scattering[k] * c.rayleigh + extinction[k] * c.mie +
                           air.ozone_absorption[k] * c.ozone;
                };
                worst = std::fmax(worst, static_cast<double>(
                                             std::fabs(std::exp(-depth(got)) - std::exp(-depth(expected)))));
            }
        }
        std::printf("light from the sun, top at %.0f km, %s: off by %.1e at most\n",
                    static_cast<double>(air.top_altitude) / 1e3, type_name<T>(), worst);
        // The tent's density, 2e-4 of a depth of 1 at most; the air above a top of 60 km to a tenth of
        // itself, 5e-4 of a grazing depth of 5.
        CHECK(worst <= (high_top ? 2e-4 : 6e-4));
    }
}

TEST_SUITE_END();
