#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/column.hpp>
#include <airlight/constants.hpp>

#include "error_metrics.hpp"
#include "quadrature.hpp"
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

// The lowest point of a path.
template <typename T>
T lowest_altitude(const AirPath<T>& path) {
    const bool through = path.along < T(0) && path.along + path.extent > T(0);
    return through ? path.perigee_altitude : glm::min(path.begin_altitude, path.end_altitude);
}

// Amounts below this share of a scale height are all underflow.
template <typename T>
long double smallest_matter(long double scale_height) {
    return scale_height * std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();
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

TEST_CASE_TEMPLATE("a path straight up ends at the top, one straight down is measured from its perigee", T,
                   float, double, long double) {
    // Small integers, exact in every type.
    const Atmosphere<T> planet = even_air(T(6400), T(100));
    const AirPath<T> up = air_path(planet, T(10), T(1), no_surface<T>());
    CHECK(up.extent == T(90));
    CHECK(up.along == T(6410));
    CHECK(up.begin_altitude == T(10));
    CHECK(up.end_altitude == T(100));
    CHECK(up.perigee_radius == T(0));
    CHECK(up.perigee_altitude == T(-6400));
    const AirPath<T> down = air_path(planet, T(110), T(-1), T(40));
    CHECK(down.extent == T(30));
    CHECK(down.along == T(-6500));
    CHECK(down.begin_altitude == T(100));
    CHECK(down.end_altitude == T(70));
    const AirPath<T> level = air_path(planet, T(10), T(0), T(0));
    CHECK(level.extent == T(0));
    CHECK(level.perigee_radius == T(6410));
    CHECK(level.perigee_altitude == T(10));
}

TEST_CASE_TEMPLATE("to a shell straight above or below it is the difference of altitudes", T, float, double,
                   long double) {
    const Atmosphere<T> planet = even_air(T(6400), T(100));
    const AirPath<T> up = air_path(planet, T(10), T(1), no_surface<T>());
    const AirPath<T> down = air_path(planet, T(90), T(-1), no_surface<T>());
    // 4 roundoffs of the docstring are at most 4 ulp.
    CHECK_WITHIN(compare_ulp("distance_to_shell", {}, distance_to_shell(T(6400), up, T(42), true), 32.0L),
                 4.0L);
    CHECK_WITHIN(compare_ulp("distance_to_shell", {}, distance_to_shell(T(6400), down, T(42), false), 48.0L),
                 4.0L);
    CHECK(distance_to_shell(T(6400), up, T(10), true) == T(0));  // exact: the factor 42 - 42
    CHECK(distance_to_shell(T(6400), up, T(4), true) <= T(0));   // behind the begin
}

TEST_CASE_TEMPLATE("a vertical column in closed form holds one scale height, and the tent its half width", T,
                   float, double, long double) {
    const Column<T> air = column_to_space<T>(earth<T>(), T(0), T(1));
    // 3e-7 by the docstring of exponential_column and 20 roundoffs; the tent to rounding by that of
    // ozone_column, which counts the radius over the half width, 424.
    const long double u = std::numeric_limits<T>::epsilon() / 2;
    CHECK_WITHIN(
        compare_relative("column_to_space.rayleigh", {}, air.rayleigh, 8000.0L * (1 - std::exp(-12.5L))),
        3e-7L + 20 * u);
    CHECK_WITHIN(compare_relative("column_to_space.mie", {}, air.mie, 1200.0L), 3e-7L + 20 * u);
    CHECK_WITHIN(compare_relative("column_to_space.ozone", {}, air.ozone, 15000.0L), 424 * u);
}

TEST_CASE_TEMPLATE("in air of density 1 the closed form is the distance", T, float, double, long double) {
    const Atmosphere<T> planet = even_air(T(6400), T(100));
    for (const T mu : {T(1), T(0.5), T(0), T(-0.0625)}) {
        const Column<T> air = column<T>(planet, T(30), mu, T(64));
        // Four weights that sum to 1, each product and sum rounding once; the tent's shells lie 1e30 away.
        CHECK_WITHIN(compare_ulp("column.rayleigh", {{"mu", mu}}, air.rayleigh, 64.0L), 6.0L);
        CHECK_WITHIN(compare_ulp("column.mie", {{"mu", mu}}, air.mie, 64.0L), 6.0L);
    }
}

TEST_CASE_TEMPLATE("in closed form columns add up along a ray split anywhere", T, float, double,
                   long double) {
    Random random(301);
    const Atmosphere<T> planet = earth<T>();
    Worst rayleigh;
    Worst mie;
    Worst tent;
    for (int i = 0; i < 5000; ++i) {
        const T h = T(random.log_uniform(1, 9e4));
        const T mu = T(random.uniform(-1, 1));
        const T distance = T(random.log_uniform(10, 1e6));
        const T first_length = T(random.uniform(0.05, 0.95)) * distance;
        if (lowest_altitude(air_path(planet, h, mu, distance)) < T(0)) {
            continue;
        }
        const T along = (planet.ground_radius + h) * mu;
        const T h_split = altitude_along_ray(planet.ground_radius, h, along, first_length);
        if (h_split >= planet.top_altitude) {
            continue;
        }
        const T mu_split = glm::clamp((along + first_length) / (planet.ground_radius + h_split), T(-1), T(1));
        const Column<T> whole = column<T>(planet, h, mu, distance);
        const Column<T> first = column<T>(planet, h, mu, first_length);
        const Column<T> second = column<T>(planet, h_split, mu_split, distance - first_length);
        // Roundoffs of the altitude that every density stems from: the split's, and what its cosine and both
        // lengths move the far end or the perigee by.
        const long double moved = static_cast<long double>(h_split) + static_cast<long double>(distance);
        const auto add = [&](Worst& worst, const char* name, T parts, T all, long double model,
                             long double scale_height) {
            const long double u = std::numeric_limits<T>::epsilon() / 2;
            const long double f = static_cast<long double>(all);
            worst.add(compare_roundoffs(
                name, {{"altitude", h}, {"mu", mu}, {"distance", distance}, {"first", first_length}}, parts,
                f, f * (60 + 6 * moved / scale_height + 2 * model / u) + smallest_matter<T>(scale_height)));
        };
        add(rayleigh, "column.rayleigh", first.rayleigh + second.rayleigh, whole.rayleigh, 3e-7L, 8000);
        add(mie, "column.mie", first.mie + second.mie, whole.mie, 3e-7L, 1200);
        // The tent's feet: an altitude off by 6 roundoffs counts by the slope over all the way in the layer.
        const long double slope = 6 * moved / 15000;
        tent.add(compare_roundoffs(
            "column.ozone", {{"altitude", h}, {"mu", mu}, {"distance", distance}, {"first", first_length}},
            first.ozone + second.ozone, static_cast<long double>(whole.ozone),
            whole.ozone * (60 + 424 + 4e-13L / (std::numeric_limits<T>::epsilon() / 2)) +
                slope * air_path(planet, h, mu, distance).extent + smallest_matter<T>(15000)));
    }
    CHECK(rayleigh.count() > 1000);
    rayleigh.print("split rays, share of the bound");
    mie.print("split rays, share of the bound");
    tent.print("split rays, share of the bound");
    // Twice the modelling error, once for each sum that holds it; 20 roundoffs of three columns.
    CHECK_WORST(rayleigh, 1.0L);
    CHECK_WORST(mie, 1.0L);
    CHECK_WORST(tent, 1.0L);
}

TEST_CASE_TEMPLATE("in closed form the air is the same from either end", T, float, double, long double) {
    Random random(302);
    const Atmosphere<T> planet = earth<T>();
    Worst rayleigh;
    Worst mie;
    Worst tent;
    for (int i = 0; i < 5000; ++i) {
        const T h = T(random.log_uniform(1, 9e4));
        const T mu = T(random.uniform(-1, 1));
        const T distance = T(random.log_uniform(10, 1e6));
        const T along = (planet.ground_radius + h) * mu;
        const T h_end = altitude_along_ray(planet.ground_radius, h, along, distance);
        if (h_end >= planet.top_altitude || lowest_altitude(air_path(planet, h, mu, distance)) < T(0)) {
            continue;
        }
        const T mu_back = glm::clamp(-(along + distance) / (planet.ground_radius + h_end), T(-1), T(1));
        const Column<T> there = column<T>(planet, h, mu, distance);
        const Column<T> back = column<T>(planet, h_end, mu_back, distance);
        // As above; the modelling error is that of one and the same path, and counts only where rounding
        // puts the two on different sides of the choice of formula.
        const long double moved = static_cast<long double>(h_end) + static_cast<long double>(distance);
        const auto add = [&](Worst& worst, const char* name, T got, T expected, long double model,
                             long double scale_height) {
            const long double u = std::numeric_limits<T>::epsilon() / 2;
            const long double f = static_cast<long double>(expected);
            worst.add(compare_roundoffs(
                name, {{"altitude", h}, {"mu", mu}, {"distance", distance}}, got, f,
                f * (40 + 6 * moved / scale_height + 2 * model / u) + smallest_matter<T>(scale_height)));
        };
        add(rayleigh, "column.rayleigh", back.rayleigh, there.rayleigh, 3e-7L, 8000);
        add(mie, "column.mie", back.mie, there.mie, 3e-7L, 1200);
        const long double slope = 6 * moved / 15000;  // the tent's feet, as above
        tent.add(compare_roundoffs(
            "column.ozone", {{"altitude", h}, {"mu", mu}, {"distance", distance}}, back.ozone,
            static_cast<long double>(there.ozone),
            there.ozone * (40 + 424 + 4e-13L / (std::numeric_limits<T>::epsilon() / 2)) +
                slope * air_path(planet, h, mu, distance).extent + smallest_matter<T>(15000)));
    }
    CHECK(rayleigh.count() > 1000);
    CHECK_WORST(rayleigh, 1.0L);
    CHECK_WORST(mie, 1.0L);
    CHECK_WORST(tent, 1.0L);
}

TEST_CASE_TEMPLATE("a longer way holds more air", T, float, double) {
    Random random(303);
    const Atmosphere<T> planet = earth<T>();
    const long double u = std::numeric_limits<T>::epsilon() / 2;
    for (int i = 0; i < 500; ++i) {
        const T h = T(random.log_uniform(0.1, 2e5));
        const T mu = T(random.uniform(-1, 1));
        Column<T> before = Column<T>{T(0), T(0), T(0)};
        for (T distance = T(0.01L); distance < T(1e6); distance *= T(1.05L)) {
            if (lowest_altitude(air_path(planet, h, mu, distance)) < T(0)) {
                break;
            }
            const Column<T> air = column<T>(planet, h, mu, distance);
            CAPTURE(exact(static_cast<long double>(h)));
            CAPTURE(exact(static_cast<long double>(mu)));
            CAPTURE(exact(static_cast<long double>(distance)));
            // Never less, to twice the docstrings' accuracy where hardly any air is left to meet: modelling
            // error, 20 roundoffs, and 3 roundoffs of altitude over scale height.
            const long double rounding = 2 * u * (20 + 3 * (static_cast<long double>(h + distance) / 1200));
            CHECK(static_cast<long double>(air.rayleigh) >=
                  static_cast<long double>(before.rayleigh) * (1 - 6e-7L - rounding));
            CHECK(static_cast<long double>(air.mie) >=
                  static_cast<long double>(before.mie) * (1 - 6e-7L - rounding));
            CHECK(static_cast<long double>(air.ozone) >=
                  static_cast<long double>(before.ozone) * (1 - 4e-13L - rounding - 424 * u));
            before = air;
        }
    }
}

TEST_CASE_TEMPLATE("closed-form columns scale exactly with the unit of length", T, float, double,
                   long double) {
    const T k = 1024;  // exact: a power of two
    Random random(304);
    const Atmosphere<T> planet = lorentzian_earth<T>();
    const Atmosphere<T> scaled = rescaled(planet, k);
    for (int i = 0; i < 2000; ++i) {
        const T h = T(random.log_uniform(0.1, 1e6));
        const T mu = T(random.uniform(-1, 1));
        const T distance = random.below(2) == 0 ? no_surface<T>() : T(random.log_uniform(1e-3, 1e6));
        const Column<T> a = column<T, Lorentzian>(planet, h, mu, distance);
        const Column<T> b = column<T, Lorentzian>(scaled, k * h, mu, k * distance);
        const Column<T> tent = column<T>(planet, h, mu, distance);
        const Column<T> scaled_tent = column<T>(scaled, k * h, mu, k * distance);
        CHECK_EQUAL(
            compare_ulp("column.rayleigh", {{"altitude", h}, {"mu", mu}}, b.rayleigh, k * a.rayleigh));
        CHECK_EQUAL(compare_ulp("column.ozone", {{"altitude", h}, {"mu", mu}}, b.ozone, k * a.ozone));
        CHECK_EQUAL(
            compare_ulp("column.ozone", {{"altitude", h}, {"mu", mu}}, scaled_tent.ozone, k * tent.ozone));
        if (static_cast<long double>(a.mie) < smallest_matter<T>(1200)) {
            continue;  // an amount below the normal numbers cannot be scaled exactly
        }
        CHECK_EQUAL(compare_ulp("column.mie", {{"altitude", h}, {"mu", mu}}, b.mie, k * a.mie));
    }
}

TEST_CASE_TEMPLATE("exponential_column gives the integral of 50 digits, above the ground", T, float, double,
                   long double) {
    Worst worst;
    Worst per_x[3];
    for (const Row& row : reference("exponential_column")) {
        Atmosphere<T> planet = earth<T>();
        planet.ground_radius = row.input<T>("ground_radius");
        planet.top_altitude = T(480000);
        const T x = row.input<T>("x");
        const T h = row.input<T>("altitude");
        const T mu = row.input<T>("mu");
        const T distance = row.text("distance") == "none" ? no_surface<T>() : row.input<T>("distance");
        const T got = exponential_column(planet.ground_radius, air_path(planet, h, mu, distance), T(8000));
        const long double expected = row.expected("column");
        // The docstring's errors of the expansion.
        const long double model = x >= T(800) ? 3e-7L : x >= T(100) ? 2e-6L : 1.7e-5L;
        const long double u = std::numeric_limits<T>::epsilon() / 2;
        worst.add(compare_roundoffs(
            "exponential_column",
            {{"radius", planet.ground_radius}, {"altitude", h}, {"mu", mu}, {"distance", distance}}, got,
            expected, 20 * row.expected("condition") + expected * model / u));
        per_x[x >= T(800)   ? 2
              : x >= T(100) ? 1
                            : 0]
            .add(compare_relative(
                "exponential_column",
                {{"radius", planet.ground_radius}, {"altitude", h}, {"mu", mu}, {"distance", distance}}, got,
                expected));
    }
    per_x[0].print("at radius / scale height = 50");
    per_x[1].print("at 100");
    per_x[2].print("from 800 on");
    worst.print("share of the modelling error and 20 roundoffs times condition");
    CHECK(worst.count() > 100);
    CHECK_WORST(worst, 1.0L);  // both are in the condition
}

TEST_CASE_TEMPLATE(
    "the closed form gives the exact column of 50 digits wherever the ray stays above the ground", T, float,
    double, long double) {
    Worst rayleigh;
    Worst mie;
    Worst tent;
    Worst lorentzian;
    Worst relative[4];
    for (const Row& row : reference("column")) {
        const T h = row.input<T>("altitude");
        const T mu = row.input<T>("mu");
        const T distance = row.text("distance") == "none" ? no_surface<T>() : row.input<T>("distance");
        if (lowest_altitude(air_path(earth<T>(), h, mu, distance)) < T(-1)) {
            continue;  // dips below the ground, where the closed form goes on growing; rounding is below 1 m
        }
        const Column<T> air = column<T>(earth<T>(), h, mu, distance);
        const Column<T> other = column<T, Lorentzian>(lorentzian_earth<T>(), h, mu, distance);
        // The table's condition is that of the midpoint sum: a roundoff of the altitude on the shortest scale
        // height. From beyond the air mu moves the perigee by the planet's radius times its roundoff.
        const long double condition =
            row.expected("condition") + (static_cast<long double>(h) > 1e5L ? 6e6L / 1200 : 0.0L);
        const auto add = [&](int which, Worst& worst, const char* name, T got, const char* expected_name,
                             long double model, long double roundoffs) {
            const long double expected = row.expected(expected_name);
            const long double u = std::numeric_limits<T>::epsilon() / 2;
            worst.add(compare_roundoffs(name, {{"altitude", h}, {"mu", mu}, {"distance", distance}}, got,
                                        expected,
                                        expected == 0 ? std::numeric_limits<T>::min()
                                                      : expected * (roundoffs + 6 * condition + model / u)));
            relative[which].add(
                compare_relative(name, {{"altitude", h}, {"mu", mu}, {"distance", distance}}, got, expected));
        };
        // 20 roundoffs by exponential_column; the radius over the thickness, 424 and 1590, by ozone_column.
        add(0, rayleigh, "column.rayleigh", air.rayleigh, "rayleigh", 3e-7L, 20);
        add(1, mie, "column.mie", air.mie, "mie", 3e-7L, 20);
        add(2, tent, "column.tent", air.ozone, "tent", 2e-13L, 424);
        add(3, lorentzian, "column.lorentzian", other.ozone, "lorentzian", 1e-4L, 1590);
    }
    for (const Worst& worst : relative) {
        worst.print("against 50 digits");
    }
    CHECK(rayleigh.count() > 25);
    // Modelling error, roundoffs and condition together make the unit.
    CHECK_WORST(rayleigh, 1.0L);
    CHECK_WORST(mie, 1.0L);
    CHECK_WORST(tent, 1.0L);
    CHECK_WORST(lorentzian, 1.0L);
}

TEST_CASE("the closed form is what marching with ever more steps tends to") {
    Random random(305);
    Worst rayleigh;
    Worst mie;
    Worst tent;
    Worst lorentzian;
    const Atmosphere<double> tent_air = earth<double>();
    const Atmosphere<double> lorentzian_air = lorentzian_earth<double>();
    for (int i = 0; i < 300; ++i) {
        const double h = random.log_uniform(1, 9e4);
        const double mu = i % 2 == 0 ? random.uniform(-1, 1) : random.uniform(-0.1, 0.1);
        const double distance = random.log_uniform(100, 3e5);
        if (lowest_altitude(air_path(tent_air, h, mu, distance)) < 0) {
            continue;
        }
        const int steps = 6000;
        const Column<double> marched = column_marched<double>(tent_air, h, mu, distance, steps);
        const Column<double> closed = column<double>(tent_air, h, mu, distance);
        const double other = column<double, Lorentzian>(lorentzian_air, h, mu, distance).ozone;
        const double other_marched =
            column_marched<double, Lorentzian>(lorentzian_air, h, mu, distance, steps).ozone;
        // Midpoint error of steps of up to 50 m: h^2 / 24 H^2 is 2e-6 of Rayleigh and 7.3e-5 of Mie. The
        // tent's corners cost a quarter of a step squared times the slope, over the amount met.
        const std::initializer_list<Input> inputs = {{"altitude", h}, {"mu", mu}, {"distance", distance}};
        rayleigh.add(compare_relative("column.rayleigh", inputs, closed.rayleigh, marched.rayleigh));
        mie.add(compare_relative("column.mie", inputs, closed.mie, marched.mie));
        if (marched.ozone > 1000) {
            tent.add(compare_relative("column.tent", inputs, closed.ozone, marched.ozone));
        }
        lorentzian.add(compare_relative("column.lorentzian", inputs, other, other_marched));
    }
    rayleigh.print("against 6000 steps");
    mie.print("against 6000 steps");
    tent.print("against 6000 steps");
    lorentzian.print("against 6000 steps");
    CHECK(rayleigh.count() > 100);
    CHECK_WORST(rayleigh, 2e-6L + 3e-7L);      // midpoint rule and docstring of exponential_column
    CHECK_WORST(mie, 7.3e-5L + 3e-7L);         // as above
    CHECK_WORST(tent, 2e-6L);                  // 3 corners of 50^2 / 4 / 15000 m on 1 km and more
    CHECK_WORST(lorentzian, 1e-4L + 1.3e-5L);  // docstring of ozone_column; midpoint on 4 km: h^2 / 12 w^2
}

TEST_CASE("a Lorentz curve of any width, centred anywhere within 8 of them, is followed") {
    using Real = long double;
    Worst worst;
    Atmosphere<Real> planet = earth<Real>();
    planet.rayleigh_scale_height = 8000;
    planet.top_altitude = 1e6L;
    for (const Real width : {0.1L, 0.25L, 0.5L, 1.0L, 2.0L, 3.0L, 3.1L, 5.0L, 10.0L, 100.0L}) {
        for (const Real centre : {0.0L, 0.5L, 1.0L, 2.0L, 4.0L, 10.0L, 30.0L}) {
            for (const Real from : {0.0L, 0.5L, 1.0L, 3.0L, 6.0L, 10.0L, 15.0L}) {
                const Real mu = from < 2 ? 0.0L : 0.3L;
                planet.ozone_half_width = 8000 * width;
                planet.ozone_altitude = 8000 * centre;
                if (centre > 8 * width) {
                    continue;
                }
                const AirPath<Real> path = air_path(planet, 8000 * from, mu, no_surface<Real>());
                const auto density = [&](Real t) {
                    const Real altitude =
                        altitude_along_ray(planet.ground_radius, path.begin_altitude, path.along, t);
                    return relative_density<Real, Lorentzian>(planet, altitude).ozone;
                };
                // Panels of half a scale height and half a half width, as long as there is air.
                const Real panel = 4000 * std::fmin(1.0L, width);
                Real expected = 0;
                Real begin = 0;
                for (Real high = 8000 * from + panel; begin < path.extent && high < 8000 * (from + 40);
                     high += panel) {
                    const Real end =
                        std::fmin(distance_to_shell(planet.ground_radius, path, high, true), path.extent);
                    expected += integrate(density, begin, end, 1e-8L);
                    begin = end;
                }
                // Of the molecules as if the path's lowest point lay at the ground.
                const Real molecules =
                    exponential_column(planet.ground_radius, path, planet.rayleigh_scale_height) *
                    std::exp(from);
                const Real got = ozone_column<Real, Lorentzian>(planet, path);
                worst.add(Comparison{"ozone_column",
                                     "Lorentzian",
                                     {{"width", width}, {"centre", centre}, {"from", from}, {"mu", mu}},
                                     expected,
                                     got,
                                     std::fabs(got - expected) / molecules,
                                     "of the molecules"});
            }
        }
    }
    worst.print("Lorentz curves of all widths, lengths in scale heights");
    CHECK_WORST(worst, 1.2e-4L);  // docstring of ozone_column
}

TEST_CASE_TEMPLATE("in closed form a term that is off has no column and changes no other", T, float, double,
                   long double) {
    const Column<T> all = column_to_space<T>(earth<T>(), T(100), T(0.3L));
    const Column<T> no_mie = column_to_space<T, NoMie>(earth<T>(), T(100), T(0.3L));
    const Column<T> no_ozone = column_to_space<T, NoOzone>(earth<T>(), T(100), T(0.3L));
    const Column<T> bare = column_to_space<T, Bare>(earth<T>(), T(100), T(0.3L));
    CHECK(all.mie > T(0));
    CHECK(all.ozone > T(0));
    CHECK(no_mie.mie == T(0));
    CHECK(no_mie.rayleigh == all.rayleigh);  // exact: the same operations
    CHECK(no_mie.ozone == all.ozone);
    CHECK(no_ozone.ozone == T(0));
    CHECK(no_ozone.rayleigh == all.rayleigh);
    CHECK(no_ozone.mie == all.mie);
    CHECK(bare.rayleigh == all.rayleigh);
    CHECK(bare.mie == T(0));
    CHECK(bare.ozone == T(0));
}

TEST_CASE_TEMPLATE("in closed form a start below the ground counts as on it, a cosine past 1 as 1", T, float,
                   double, long double) {
    const Atmosphere<T> planet = earth<T>();
    const auto check_same = [](const Column<T>& a, const Column<T>& b) {
        CHECK(a.rayleigh == b.rayleigh);  // exact: the same numbers after clamping
        CHECK(a.mie == b.mie);
        CHECK(a.ozone == b.ozone);
    };
    for (const T depth : {T(1), T(1e5L), planet.ground_radius}) {
        check_same(column_to_space<T>(planet, -depth, T(0.5)), column_to_space<T>(planet, T(0), T(0.5)));
    }
    const T past = T(1) + std::numeric_limits<T>::epsilon();
    check_same(column_to_space<T>(planet, T(5000), past), column_to_space<T>(planet, T(5000), T(1)));
    check_same(column<T>(planet, T(5000), -past, T(4000)), column<T>(planet, T(5000), T(-1), T(4000)));
}

TEST_CASE_TEMPLATE("below the ground the closed form grows with the depth and stays finite", T, float, double,
                   long double) {
    // Documented: nothing passes there, so what counts is that transmittance falls to 0 and nothing
    // overflows.
    const Column<T> shallow = column<T>(earth<T>(), T(0), T(-1), T(8000));
    // One scale height down, H (e - 1); 3e-7 and 20 roundoffs by the docstring, 3 of the altitude of the end.
    CHECK_WITHIN(compare_relative("column.rayleigh", {}, shallow.rayleigh, 8000.0L * std::expm1(1.0L)),
                 3e-7L + 23 * (std::numeric_limits<T>::epsilon() / 2));
    const Column<T> through = column<T>(earth<T>(), T(0), T(-1), no_surface<T>());
    CHECK(through.rayleigh > T(1e20L));
    CHECK(std::isfinite(through.rayleigh));
    CHECK(std::isfinite(through.mie));
    CHECK(std::isfinite(through.ozone));
}

TEST_CASE_TEMPLATE("in closed form no distance, no air, no thickness give no column", T, float, double,
                   long double) {
    const auto check_nothing = [](const Column<T>& air) {
        CHECK(air.rayleigh == T(0));
        CHECK(air.mie == T(0));
        CHECK(air.ozone == T(0));
    };
    const Atmosphere<T> planet = earth<T>();
    check_nothing(column<T>(planet, T(100), T(0.3L), T(0)));
    check_nothing(column_to_space<T>(planet, T(200e3L), T(0.3L)));
    check_nothing(column_to_space<T>(planet, T(200e3L), T(-0.1L)));
    check_nothing(column<T>(planet, T(200e3L), T(-1), T(50e3L)));
    Atmosphere<T> thin = planet;
    thin.rayleigh_scale_height = T(0);
    thin.mie_scale_height = T(0);
    thin.ozone_half_width = T(0);
    check_nothing(column_to_space<T>(thin, T(0), T(1)));
    check_nothing(column_to_space<T, Lorentzian>(thin, T(0), T(1)));
}

TEST_CASE_TEMPLATE("a layer thicker than the planet still counts what lies above the ground", T, float,
                   double, long double) {
    Atmosphere<T> planet = even_air(T(1000), T(100));
    planet.ozone_half_width = T(5000);
    // Its lower shell lies past the centre, at -5000. Straight up 100 - 100^2 / (2 5000), by hand; a dozen
    // roundings of the shells' distances and the samples on numbers up to 1100: 11 each of the result.
    for (const T altitude : {T(0), T(20)}) {
        const long double a = static_cast<long double>(altitude);
        const Column<T> air = column_to_space<T>(planet, altitude, T(1));
        CHECK_WITHIN(compare_ulp("column_to_space.ozone", {{"altitude", altitude}}, air.ozone,
                                 (100 - a) - (100 * 100 - a * a) / 10000),
                     12 * 11.0L);
    }
}

TEST_CASE_TEMPLATE("every planet, ray and distance has a finite column that is not negative", T, float,
                   double) {
    Random random(306);
    long bad = 0;
    for (int i = 0; i < 200000; ++i) {
        Atmosphere<T> planet = earth<T>();
        const double radius = random.log_uniform(100, 7e7);
        planet.ground_radius = T(radius);
        planet.top_altitude = T(random.log_uniform(1, 2e6));
        const auto thickness = [&] { return random.below(20) == 0 ? T(0) : T(random.log_uniform(0.1, 1e6)); };
        planet.rayleigh_scale_height = thickness();
        planet.mie_scale_height = thickness();
        planet.ozone_half_width = thickness();
        planet.ozone_altitude = T(random.log_uniform(1, 1e6));
        const int where = random.below(5);
        const T h = where == 0   ? T(0)
                    : where == 1 ? -T(random.uniform(0, 1)) * planet.ground_radius
                    : where == 2 ? planet.top_altitude
                    : where == 3 ? T(random.log_uniform(1e-6, 1e12))
                                 : T(random.uniform(0, 1)) * planet.top_altitude;
        const int which = random.below(6);
        // The last: at the horizon, where the ray just touches the ground.
        const T touch =
            -T(std::sqrt(std::max(0.0, 1 - std::pow(radius / (radius + std::fabs(double(h))), 2))));
        const T mu = which == 0   ? T(1)
                     : which == 1 ? T(-1)
                     : which == 2 ? T(0)
                     : which == 3 ? T(random.uniform(-1e-3, 1e-3))
                     : which == 4 ? touch
                                  : T(random.uniform(-1, 1));
        const int how_far = random.below(5);
        const T distance = how_far == 0   ? T(0)
                           : how_far == 1 ? T(1e-6L)
                           : how_far == 2 ? no_surface<T>()
                                          : T(random.log_uniform(1e-6, 1e12));
        const Column<T> tent = column<T>(planet, h, mu, distance);
        const Column<T> lorentzian = column<T, Lorentzian>(planet, h, mu, distance);
        for (const T amount :
             {tent.rayleigh, tent.mie, tent.ozone, lorentzian.rayleigh, lorentzian.mie, lorentzian.ozone}) {
            if (!(amount >= T(0)) || !std::isfinite(amount)) {
                ++bad;
                CAPTURE(exact(static_cast<long double>(radius)));
                CAPTURE(exact(static_cast<long double>(planet.top_altitude)));
                CAPTURE(exact(static_cast<long double>(planet.rayleigh_scale_height)));
                CAPTURE(exact(static_cast<long double>(planet.mie_scale_height)));
                CAPTURE(exact(static_cast<long double>(planet.ozone_half_width)));
                CAPTURE(exact(static_cast<long double>(planet.ozone_altitude)));
                CAPTURE(exact(static_cast<long double>(h)));
                CAPTURE(exact(static_cast<long double>(mu)));
                CAPTURE(exact(static_cast<long double>(distance)));
                CAPTURE(exact(static_cast<long double>(amount)));
                CHECK_MESSAGE(bad > 5, "a column that is negative or not finite");  // five stories are enough
            }
        }
    }
    CHECK(bad == 0);
}

TEST_SUITE_END();
