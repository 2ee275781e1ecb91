#include <cmath>
#include <cstdio>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/column.hpp>
#include <airlight/constants.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// Air of the reference table: the default Earth; the Lorentz profile has its own numbers.
template <typename T>
Atmosphere<T> lorentzian_earth() {
    Atmosphere<T> planet = earth<T>();
    planet.ozone_altitude = T(30e3L);
    planet.ozone_half_width = T(4e3L);
    return planet;
}

// Air of the same density everywhere: scale heights so large that exp rounds to 1.
template <typename T>
Atmosphere<T> even_air(T ground_radius, T top_altitude) {
    Atmosphere<T> planet = earth<T>();
    planet.ground_radius = ground_radius;
    planet.top_altitude = top_altitude;
    planet.rayleigh_scale_height = T(1e30L);
    planet.mie_scale_height = T(1e30L);
    planet.ozone_altitude = T(0);
    planet.ozone_half_width = T(1e30L);
    return planet;
}

// Error of a column in double against a table's row.
double column_error(double got, long double expected) {
    return static_cast<double>(std::fabs(static_cast<long double>(got) - expected));
}

}  // namespace

TEST_SUITE_BEGIN("column");

TEST_CASE_TEMPLATE("at the ground all densities but ozone's are 1", T, float, double, long double) {
    const Density<T> ground = relative_density<T>(earth<T>(), T(0));
    CHECK(ground.rayleigh == T(1));  // exact: exp(0)
    CHECK(ground.mie == T(1));
    CHECK(ground.ozone == T(0));  // the tent starts at 10 km
    CHECK(relative_density<T>(earth<T>(), T(25e3L)).ozone == T(1));
}

TEST_CASE_TEMPLATE("in air of density 1 the column is the distance, with however many steps", T, float,
                   double, long double) {
    // Our choice is the midpoint rule: N samples for N intervals. N + 1 samples would give 1 + 1 / N times
    // too much.
    const Atmosphere<T> planet = even_air(T(6400), T(100));
    for (const int steps : {1, 2, 7, 30, 800}) {
        const Column<T> air = column_marched<T>(planet, T(10), T(1), T(64), steps);
        // N ones are summed exactly; 64 / N and the product with N round.
        CHECK_WITHIN(compare_ulp("column_marched.rayleigh", {{"steps", T(steps)}}, air.rayleigh, 64.0L),
                     1.0L);
        CHECK_WITHIN(compare_ulp("column_marched.mie", {{"steps", T(steps)}}, air.mie, 64.0L), 1.0L);
        CHECK_WITHIN(compare_ulp("column_marched.ozone", {{"steps", T(steps)}}, air.ozone, 64.0L), 1.0L);
    }
}

TEST_CASE_TEMPLATE("one step has the density of the middle", T, float, double, long double) {
    const Column<T> air = column_marched<T>(earth<T>(), T(0), T(1), T(16000), 1);
    // exp(-1) 16 km; the altitude of the sample is 8 km to a few roundoffs, worth as many of the result.
    CHECK_WITHIN(compare_ulp("column_marched.rayleigh", {}, air.rayleigh,
                             16000.0L * 0.367879441171442321595523770161460867446L),
                 6.0L);
}

TEST_CASE("a vertical column holds one scale height of each substance, and the tent its half width") {
    const Column<double> air = column_marched<double>(earth<double>(), 0.0, 1.0, no_surface<double>(), 20000);
    // Midpoint error h^2 / 24 H^2 of 5 m steps: 7e-7 on 1200 m; e^-12.5 of the Rayleigh air lies above the
    // top.
    CHECK_WITHIN(
        compare_relative("column_marched.rayleigh", {}, air.rayleigh, 8000.0L * (1 - std::exp(-12.5L))),
        1e-6L);
    CHECK_WITHIN(compare_relative("column_marched.mie", {}, air.mie, 1200.0L), 1e-6L);
    CHECK_WITHIN(compare_relative("column_marched.ozone", {}, air.ozone, 15000.0L), 1e-6L);
}

TEST_CASE_TEMPLATE(
    "columns add up along a split ray, to the midpoint rule's error or exactly where steps agree", T, float,
    double, long double) {
    // Split in the middle with half the steps each, the samples are the same; their altitudes are found from
    // another start.
    Random random(91);
    const Atmosphere<T> planet = earth<T>();
    Worst worst;
    for (int i = 0; i < 500; ++i) {
        const T h = T(random.log_uniform(1, 5e4));
        const T mu = T(random.uniform(0.02, 1));
        const T distance = T(random.log_uniform(10, 1e5));
        const Column<T> whole = column_marched<T>(planet, h, mu, distance, 64);
        const T half = distance / 2;
        const T along = (planet.ground_radius + h) * mu;
        const T h_half = altitude_along_ray(planet.ground_radius, h, along, half);
        if (h_half >= planet.top_altitude ||
            altitude_along_ray(planet.ground_radius, h, along, distance) >= planet.top_altitude) {
            continue;
        }
        const T mu_half = glm::min((along + half) / (planet.ground_radius + h_half), T(1));
        const Column<T> first = column_marched<T>(planet, h, mu, half, 32);
        const Column<T> second = column_marched<T>(planet, h_half, mu_half, half, 32);
        // An altitude found in two steps is off by 3 roundoffs of itself twice, and by the half way times the
        // rounding of mu; a scale height turns that into a relative error of the density. Sums of 64 cost 20
        // more.
        const long double w = static_cast<long double>(h_half) + static_cast<long double>(distance);
        worst.add(compare_roundoffs(
            "column_marched.rayleigh", {{"altitude", h}, {"mu", mu}, {"distance", distance}},
            first.rayleigh + second.rayleigh, whole.rayleigh, whole.rayleigh * (20 + 6 * w / 8000)));
    }
    CHECK(worst.count() > 200);
    CHECK_WORST(worst, 1.0L);
}

TEST_CASE("split anywhere, columns add up to the midpoint rule's error") {
    Random random(92);
    const Atmosphere<double> planet = earth<double>();
    for (int i = 0; i < 200; ++i) {
        const double h = random.log_uniform(1, 2e4);
        const double mu = random.uniform(-0.02, 1);
        const double distance = random.log_uniform(1e3, 3e5);
        const double share = random.uniform(0.1, 0.9);
        const double along = (planet.ground_radius + h) * mu;
        const double h_split = altitude_along_ray(planet.ground_radius, h, along, share * distance);
        if (h_split > 9e4 || h_split < 0) {
            continue;
        }
        const double mu_split = (along + share * distance) / (planet.ground_radius + h_split);
        const double whole = column_marched<double>(planet, h, mu, distance, 4000).rayleigh;
        const double parts =
            column_marched<double>(planet, h, mu, share * distance, 4000).rayleigh +
            column_marched<double>(planet, h_split, mu_split, (1 - share) * distance, 4000).rayleigh;
        // Steps of up to 75 m on 8 km: h^2 / 24 H^2 = 4e-6.
        CHECK_WITHIN(compare_relative("column_marched.rayleigh",
                                      {{"altitude", h}, {"mu", mu}, {"distance", distance}}, parts, whole),
                     4e-6L);
    }
}

TEST_CASE_TEMPLATE("from either end the air is the same", T, float, double, long double) {
    Random random(93);
    const Atmosphere<T> planet = earth<T>();
    Worst worst;
    for (int i = 0; i < 500; ++i) {
        const T h = T(random.log_uniform(1, 5e4));
        const T mu = T(random.uniform(-0.02, 1));
        const T distance = T(random.log_uniform(10, 1e5));
        const T along = (planet.ground_radius + h) * mu;
        const T h_end = altitude_along_ray(planet.ground_radius, h, along, distance);
        if (h_end >= planet.top_altitude || h_end < T(0)) {
            continue;
        }
        const T mu_back = glm::clamp(-(along + distance) / (planet.ground_radius + h_end), T(-1), T(1));
        const Column<T> there = column_marched<T>(planet, h, mu, distance, 64);
        const Column<T> back = column_marched<T>(planet, h_end, mu_back, distance, 64);
        // As above: the same samples, altitudes found from the other end.
        const long double w = static_cast<long double>(h_end) + static_cast<long double>(distance);
        worst.add(compare_roundoffs("column_marched.rayleigh",
                                    {{"altitude", h}, {"mu", mu}, {"distance", distance}}, back.rayleigh,
                                    there.rayleigh, there.rayleigh * (20 + 6 * w / 8000)));
    }
    CHECK(worst.count() > 200);
    CHECK_WORST(worst, 1.0L);
}

TEST_CASE_TEMPLATE("columns scale exactly with the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two
    Random random(94);
    const Atmosphere<T> planet = lorentzian_earth<T>();
    const Atmosphere<T> scaled = rescaled(planet, k);
    for (int i = 0; i < 500; ++i) {
        const T h = T(random.log_uniform(0.1, 1e6));
        const T mu = T(random.uniform(-1, 1));
        const T distance = random.below(2) == 0 ? no_surface<T>() : T(random.log_uniform(1, 1e6));
        const Column<T> a = column_marched<T, Lorentzian>(planet, h, mu, distance, 16);
        const Column<T> b = column_marched<T, Lorentzian>(scaled, k * h, mu, k * distance, 16);
        CHECK_EQUAL(compare_ulp("column_marched.rayleigh", {{"altitude", h}, {"mu", mu}}, b.rayleigh,
                                k * a.rayleigh));
        CHECK_EQUAL(compare_ulp("column_marched.mie", {{"altitude", h}, {"mu", mu}}, b.mie, k * a.mie));
        CHECK_EQUAL(compare_ulp("column_marched.ozone", {{"altitude", h}, {"mu", mu}}, b.ozone, k * a.ozone));
    }
}

TEST_CASE_TEMPLATE("16 steps give the midpoint sum of 50 digits", T, float, double, long double) {
    Worst rayleigh;
    Worst mie;
    Worst tent;
    Worst lorentzian;
    for (const Row& row : reference("column")) {
        const T h = row.input<T>("altitude");
        const T mu = row.input<T>("mu");
        const T distance = row.text("distance") == "none" ? no_surface<T>() : row.input<T>("distance");
        const Column<T> air = column_marched<T>(earth<T>(), h, mu, distance, 16);
        const Column<T> other = column_marched<T, Lorentzian>(lorentzian_earth<T>(), h, mu, distance, 16);
        // How a roundoff of the altitudes acts on the density of the shortest scale height; from beyond the
        // air, mu moves the perigee by the planet's radius times its roundoff, and the entry with it.
        const long double condition =
            row.expected("condition") + (static_cast<long double>(h) > 1e5L ? 6e6L / 1200 : 0.0L);
        const auto add = [&](Worst& worst, const char* name, T got, long double expected) {
            worst.add(
                compare_roundoffs(name, {{"altitude", h}, {"mu", mu}, {"distance", distance}}, got, expected,
                                  expected == 0 ? std::numeric_limits<T>::min() : expected * condition));
        };
        add(rayleigh, "column_marched.rayleigh", air.rayleigh, row.expected("rayleigh_16"));
        add(mie, "column_marched.mie", air.mie, row.expected("mie_16"));
        add(lorentzian, "column_marched.ozone", other.ozone, row.expected("lorentzian_16"));
        // The tent's corner: a sample near its foot is all difference, so the error counts against a whole
        // step.
        const long double reach = static_cast<long double>(air.rayleigh > T(0) ? T(1000) : T(1));
        tent.add(compare_roundoffs("column_marched.tent",
                                   {{"altitude", h}, {"mu", mu}, {"distance", distance}}, air.ozone,
                                   row.expected("tent_16"), (row.expected("tent_16") + reach) * condition));
    }
    rayleigh.print("against 50 digits");
    mie.print("against 50 digits");
    lorentzian.print("against 50 digits");
    tent.print("against 50 digits");
    // 3 roundoffs of each altitude (the docstring of altitude_along_ray) and as many of the step and the sum.
    CHECK_WORST(rayleigh, 6.0L);
    CHECK_WORST(mie, 6.0L);
    CHECK_WORST(lorentzian, 6.0L);
    CHECK_WORST(tent, 6.0L);
}

TEST_CASE("the error falls by four when the steps double, down to the exact column") {
    int smooth = 0;
    const Atmosphere<double> planet = earth<double>();
    for (const Row& row : reference("column")) {
        const double h = row.input<double>("altitude");
        const double mu = row.input<double>("mu");
        const double distance =
            row.text("distance") == "none" ? no_surface<double>() : row.input<double>("distance");
        const auto march = [&](int steps) {
            return column_marched<double>(earth<double>(), h, mu, distance, steps);
        };
        const Column<double> coarse = march(2000);
        const Column<double> fine = march(4000);
        CAPTURE(exact(h));
        CAPTURE(exact(mu));
        CAPTURE(exact(distance));
        // Second order in the step: a step of 0.6 km at most on 8 km: h^2 / 24 H^2 = 2e-4 of the densest
        // part.
        CHECK_WITHIN(compare_relative("column_marched.rayleigh", {{"steps", 4000}}, fine.rayleigh,
                                      row.expected("rayleigh")),
                     1e-5L);
        CHECK_WITHIN(
            compare_relative("column_marched.ozone", {{"steps", 4000}}, fine.ozone, row.expected("tent")),
            1e-5L);
        const double before = column_error(coarse.rayleigh, row.expected("rayleigh"));
        const double after = column_error(fine.rayleigh, row.expected("rayleigh"));
        const double perigee = (planet.ground_radius + h) * std::sqrt((1 - mu) * (1 + mu));
        if (mu < 0 && perigee < planet.ground_radius && distance > h) {
            continue;  // dips below the ground, where the density has a corner: the order is not regular
                       // there
        }
        if (before > 1e-10 * coarse.rayleigh) {  // else rounding is all that is left
            CHECK(std::fabs(convergence_order(before, after) - 2.0) <= 0.03);  // the next order's share
            ++smooth;
        }
        const Column<double> coarse_lorentzian =
            column_marched<double, Lorentzian>(lorentzian_earth<double>(), h, mu, distance, 2000);
        const Column<double> fine_lorentzian =
            column_marched<double, Lorentzian>(lorentzian_earth<double>(), h, mu, distance, 4000);
        const double lorentzian_before = column_error(coarse_lorentzian.ozone, row.expected("lorentzian"));
        const double lorentzian_after = column_error(fine_lorentzian.ozone, row.expected("lorentzian"));
        CHECK_WITHIN(compare_relative("column_marched.ozone", {{"steps", 4000}}, fine_lorentzian.ozone,
                                      row.expected("lorentzian")),
                     1e-5L);
        if (lorentzian_before > 1e-10 * coarse_lorentzian.ozone) {
            CHECK(std::fabs(convergence_order(lorentzian_before, lorentzian_after) - 2.0) <= 0.06);
        }
    }
    CHECK(smooth > 20);
}

TEST_CASE("a zenith column of 60 km in 30 steps is short by 0.3 % and 10 %, not 13 % and 106 % too much") {
    // Our choice: the midpoint rule. Summing N + 1 samples over N intervals overshoots by those figures.
    const Column<double> air = column_marched<double>(earth<double>(), 0.0, 1.0, 60e3, 30);
    const double rayleigh = air.rayleigh / (8000 * (1 - std::exp(-7.5))) - 1;
    const double mie = air.mie / 1200 - 1;
    std::printf("midpoint rule, zenith, 30 steps of 2 km: Rayleigh %+.2f %%, Mie %+.2f %%\n", 100 * rayleigh,
                100 * mie);
    // h / H / (2 sinh(h / 2H)) - 1 by hand: -0.26 % for 2 km on 8 km, -10.7 % for 2 km on 1.2 km.
    CHECK(std::fabs(rayleigh + 0.0026) <= 5e-5);  // half a unit of the last digit
    CHECK(std::fabs(mie + 0.107) <= 5e-4);
    double ends_too = 0.0;
    for (int i = 0; i <= 30; ++i) {
        ends_too += 2000.0 * std::exp(-i * 2000.0 / 8000.0);
    }
    ends_too = ends_too / (8000 * (1 - std::exp(-7.5))) - 1;
    CHECK(std::fabs(ends_too - 0.13) <= 0.005);  // the figure that our choice avoids
}

TEST_CASE(
    "a Lorentz layer times the Rayleigh density peaks at 28.9 km with 0.025, not at its centre of 30 km") {
    // Our choice: a profile of its own, documented as what it is.
    double peak = 0.0;
    double peak_altitude = 0.0;
    for (int i = 0; i <= 60000; ++i) {
        const double density = relative_density<double, Lorentzian>(lorentzian_earth<double>(), i).ozone;
        if (density > peak) {
            peak = density;
            peak_altitude = i;
        }
    }
    CHECK(std::fabs(peak_altitude - 28.9e3) <= 50);  // half a unit of the last digit
    CHECK(std::fabs(peak - 0.025) <= 0.0005);
}

TEST_CASE(
    "the Lorentz layer's zenith optical depth is (0.010, 0.025, 0.001), the tent's (0.010, 0.028, 0.001)") {
    const Atmosphere<double> leenman = leenman_earth<double>();
    const double lorentzian =
        column_marched<double, Lorentzian>(leenman, 0.0, 1.0, no_surface<double>(), 4000).ozone;
    const double tent = column_marched<double>(earth<double>(), 0.0, 1.0, no_surface<double>(), 4000).ozone;
    const double printed_lorentzian[] = {0.010, 0.025, 0.001};
    const double printed_tent[] = {0.010, 0.028, 0.001};
    for (int i = 0; i < 3; ++i) {
        CHECK(std::fabs(leenman.ozone_absorption[i] * lorentzian - printed_lorentzian[i]) <=
              5e-4);  // half the last digit
        CHECK(std::fabs(earth<double>().ozone_absorption[i] * tent - printed_tent[i]) <= 5e-4);
    }
}

TEST_CASE_TEMPLATE("a term that is off has no column and changes no other", T, float, double, long double) {
    const Column<T> all = column_marched<T>(earth<T>(), T(100), T(0.3L), no_surface<T>(), 32);
    const Column<T> no_mie = column_marched<T, NoMie>(earth<T>(), T(100), T(0.3L), no_surface<T>(), 32);
    const Column<T> no_ozone = column_marched<T, NoOzone>(earth<T>(), T(100), T(0.3L), no_surface<T>(), 32);
    CHECK(no_mie.mie == T(0));
    CHECK(no_mie.rayleigh == all.rayleigh);  // exact: the same operations
    CHECK(no_mie.ozone == all.ozone);
    CHECK(no_ozone.ozone == T(0));
    CHECK(no_ozone.rayleigh == all.rayleigh);
    CHECK(no_ozone.mie == all.mie);
}

TEST_CASE_TEMPLATE("below the ground the air is as dense as at the ground, and nothing overflows", T, float,
                   double, long double) {
    // Our reading of a source whose light ray has no planet test: its density grows as exp(depth / H) and
    // overflows float within 106 km. A clamped density gives the length of the way.
    const Atmosphere<T> planet = earth<T>();
    const Column<T> through = column_marched<T>(planet, T(0), T(-1), T(12720e3L), 64);
    // 64 ones times the step; each product rounds once.
    CHECK_WITHIN(compare_ulp("column_marched.rayleigh", {}, through.rayleigh, 12720e3L), 1.0L);
    CHECK_WITHIN(compare_ulp("column_marched.mie", {}, through.mie, 12720e3L), 1.0L);
    // A start below the ground counts as on it.
    for (const T depth : {T(1), T(1e5L), planet.ground_radius}) {
        const Column<T> below = column_marched<T>(planet, -depth, T(0.5), no_surface<T>(), 32);
        const Column<T> on = column_marched<T>(planet, T(0), T(0.5), no_surface<T>(), 32);
        CHECK(below.rayleigh == on.rayleigh);  // exact: the same altitude after clamping
        CHECK(below.mie == on.mie);
        CHECK(below.ozone == on.ozone);
    }
}

TEST_CASE_TEMPLATE("a cosine that rounding pushed past 1 counts as 1", T, float, double, long double) {
    const T past = T(1) + std::numeric_limits<T>::epsilon();
    for (const T sign : {T(1), T(-1)}) {
        const Column<T> got = column_marched<T>(earth<T>(), T(5000), sign * past, T(4000), 8);
        const Column<T> vertical = column_marched<T>(earth<T>(), T(5000), sign, T(4000), 8);
        CHECK(got.rayleigh == vertical.rayleigh);  // exact: the same cosine after clamping
        CHECK(got.mie == vertical.mie);
    }
}

TEST_CASE_TEMPLATE("no distance, no steps, no air, no column", T, float, double, long double) {
    const auto check_nothing = [](const Column<T>& air) {
        CHECK(air.rayleigh == T(0));
        CHECK(air.mie == T(0));
        CHECK(air.ozone == T(0));
    };
    const Atmosphere<T> planet = earth<T>();
    check_nothing(column_marched<T>(planet, T(100), T(0.3L), T(0), 32));
    check_nothing(column_marched<T>(planet, T(100), T(0.3L), T(1000), 0));
    check_nothing(column_marched<T>(planet, T(100), T(0.3L), T(1000), -5));
    check_nothing(column_marched<T>(planet, T(200e3L), T(0.3L), no_surface<T>(), 32));
    check_nothing(column_marched<T>(planet, T(200e3L), T(-0.1L), no_surface<T>(), 32));
    check_nothing(column_marched<T>(planet, T(200e3L), T(-1), T(50e3L), 32));
    Atmosphere<T> thin = planet;
    thin.rayleigh_scale_height = T(0);
    thin.mie_scale_height = T(0);
    thin.ozone_half_width = T(0);
    check_nothing(column_marched<T>(thin, T(0), T(1), no_surface<T>(), 32));
    check_nothing(column_marched<T, Lorentzian>(thin, T(0), T(1), no_surface<T>(), 32));
}

TEST_SUITE_END();
