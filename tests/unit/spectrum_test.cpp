#include <cmath>

#include <doctest/doctest.h>
#include <airlight/color.hpp>
#include <airlight/spectrum.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("spectrum");

TEST_CASE_TEMPLATE("king_factor of no depolarisation is 1, and of 2/9 it is 1.5", T, float, double,
                   long double) {
    CHECK(king_factor(T(0)) == T(1));  // exact: 6 / 6
    // (6 + 2/3) / (6 - 14/9) = 1.5; the rounding of 2/9 moves it by 7 d / (6 - 7 d) = 0.35 roundoffs more.
    CHECK_WITHIN(
        compare_ulp("king_factor", {{"depolarisation_ratio", T(2) / T(9)}}, king_factor(T(2) / T(9)), 1.5L),
        3.0L);
}

TEST_CASE_TEMPLATE("King's factor of dry air is the published 1.048 and 1.061", T, float, double,
                   long double) {
    // Young's depolarisation 0.0279 gives 1.0480, Penndorf's 0.035 gives 1.0608: half a unit of the last
    // digit, and one more for Young's, printed from a ratio of three digits.
    CHECK_WITHIN(compare_relative("king_factor", {{"d", 0.0279L}}, king_factor(T(0.0279L)), 1.0480L), 1e-4L);
    CHECK_WITHIN(compare_relative("king_factor", {{"d", 0.035L}}, king_factor(T(0.035L)), 1.0608L), 5e-5L);
}

TEST_CASE_TEMPLATE("the Rayleigh coefficient is 8 pi^3 (n^2 - 1)^2 / (3 N lambda^4)", T, float, double,
                   long double) {
    // n = 2, N = 1, lambda = 1: 8 pi^3 9 / 3 = 24 pi^3. Pi cubed and three more operations round.
    CHECK_WITHIN(
        compare_ulp("rayleigh_coefficient", {{"refractivity", 1}, {"number_density", 1}, {"wavelength", 1}},
                    rayleigh_coefficient(T(1), T(1), T(1)), 744.15064032719568421143156161L),
        4.0L + table_rounding<T>());
}

TEST_CASE_TEMPLATE("the refractive index enters squared: twice the refractivity scatters four times", T,
                   float, double, long double) {
    // Our reading where a source prints the polarisability with an unsquared n^2 - 1.
    const T thin = T(0x1p-12L);  // (2 + 2 x)^2 / (2 + x)^2 = 1 + x + ..., known exactly
    const T ratio =
        rayleigh_coefficient(2 * thin, T(1e7L), T(0.5)) / rayleigh_coefficient(thin, T(1e7L), T(0.5));
    const long double x = thin;
    const long double expected = 4 * (2 + 2 * x) * (2 + 2 * x) / ((2 + x) * (2 + x));
    CHECK_WITHIN(compare_ulp("rayleigh_coefficient", {{"refractivity", thin}}, ratio, expected),
                 8.0L);  // two of 4 ulp
}

TEST_CASE_TEMPLATE(
    "by way of the polarisability: 4 pi N alpha / lambda^4, in air thinner than it was measured in", T, float,
    double, long double) {
    // Sources that keep the air measured, N_e, apart from the air there, N: alpha = 2 pi^2 (n^2 - 1)^2 /
    // (3 N_e^2). The same molecules k times as dense refract k times as much, to (2 + k x) / (2 + x) of it.
    const long double measured_density = 2.5e7L;
    const T refractivity = T(0x1p-12L);
    const long double x = refractivity;
    const long double contrast = x * (2 + x);
    const long double alpha = 2 * pi<long double> * pi<long double> * contrast * contrast /
                              (3 * measured_density * measured_density);
    for (const long double k : {1.0L, 0.5L, 0.0625L}) {  // powers of two: exact inputs
        const T density = T(k * measured_density);
        const long double squared = (2 + k * x) / (2 + x) * ((2 + k * x) / (2 + x));
        const long double expected =
            4 * pi<long double> * static_cast<long double>(density) * alpha / 0.0625L * squared;
        const T got = rayleigh_coefficient(T(k) * refractivity, density, T(0.5));
        CHECK_WITHIN(compare_ulp("rayleigh_coefficient", {{"k", k}}, got, expected),
                     8.0L + 8 * table_rounding<T>());  // the docstring's; the reference rounds as often
    }
}

TEST_CASE_TEMPLATE("blue light scatters as wavelength to the minus four", T, float, double, long double) {
    for (const T wavelength : {T(0.44L), T(0.55L), T(0.68L)}) {
        // Exact: halving the wavelength changes only exponents.
        CHECK(rayleigh_coefficient(T(3e-4L), T(2.5e7L), wavelength / 2) ==
              16 * rayleigh_coefficient(T(3e-4L), T(2.5e7L), wavelength));
    }
}

TEST_CASE_TEMPLATE(
    "n = 1.0003, N = 2.545e25 at 650, 510, 475 nm is the triple (6.55, 17.3, 23.0)e-6 per metre", T, float,
    double, long double) {
    // Wavelengths and N in um keep float in range; the result in 1/um is a millionth of that in 1/m.
    const long double printed[] = {6.55L, 17.3L, 23.0L};
    const T wavelengths[] = {T(0.65L), T(0.51L), T(0.475L)};
    for (int i = 0; i < 3; ++i) {
        const T got = rayleigh_coefficient(T(3e-4L), T(2.545e7L), wavelengths[i]) * T(1e12L);
        // Half a unit of the last printed digit of 17.3 is 0.3 %, of 6.55 0.08 %, of 23.0 0.2 %.
        CHECK_WITHIN(
            compare_relative("rayleigh_coefficient", {{"wavelength", wavelengths[i]}}, got, printed[i]),
            0.003L);
    }
}

TEST_CASE_TEMPLATE("an aerosol of albedo 0.9 absorbs a ninth of what it scatters", T, float, double,
                   long double) {
    // Our reading where two sources differ: extinction = scattering / 0.9. Reading absorption = scattering /
    // 0.9 would make the albedo 0.474.
    const vec3<T> scattering = vec3<T>(T(0.9L), T(1.8L), T(2e-6L));
    const vec3<T> absorption = absorption_from_albedo(scattering, T(0.9L));
    for (int i = 0; i < 3; ++i) {
        // 1 - albedo keeps its digits but amplifies the albedo's rounding by 0.9 / 0.1 = 9 roundoffs.
        CHECK_WITHIN(compare_roundoffs("absorption_from_albedo", {{"scattering", scattering[i]}},
                                       absorption[i], scattering[i] / 9.0L, 11.0L * scattering[i] / 9.0L),
                     1.0L);
        const T albedo = scattering[i] / (scattering[i] + absorption[i]);
        CHECK_WITHIN(compare_ulp("single-scattering albedo", {{"scattering", scattering[i]}}, albedo, 0.9L),
                     3.0L);
        CHECK(std::fabs(static_cast<long double>(albedo) - 0.474L) > 0.4L);
    }
    CHECK(absorption_from_albedo(scattering, T(1)) == vec3<T>(T(0)));  // exact: nothing is absorbed
}

TEST_CASE_TEMPLATE("visibility: 3.912 / V by Koschmieder's 2 %, 2.996 / V by the 5 % of the optical range", T,
                   float, double, long double) {
    // Half a unit of the last printed digit.
    CHECK_WITHIN(compare_relative("extinction_from_visibility", {{"visibility", 1}},
                                  extinction_from_visibility(T(1), koschmieder_contrast<T>), 3.912L),
                 0.0005L / 3.912L);
    CHECK_WITHIN(compare_relative("extinction_from_visibility", {{"visibility", 1}},
                                  extinction_from_visibility(T(1), optical_range_contrast<T>), 2.996L),
                 0.0005L / 2.996L);
    CHECK(extinction_from_visibility(T(5), T(1)) == T(0));  // exact: ln 1
    // Through the air as far as one sees, the contrast is what is left.
    const T extinction = extinction_from_visibility(T(23000), T(0.02L));
    const T left = std::exp(-extinction * T(23000));
    // exp turns the depth 3.9, rounded three times, into that many roundoffs of the result.
    CHECK_WITHIN(compare_roundoffs("exp(-extinction visibility)", {}, left,
                                   static_cast<long double>(T(0.02L)), 0.02L * (3 * 3.92L + 2)),
                 1.0L);
}

TEST_CASE_TEMPLATE("Angstrom's law: 1 at the reference, a half at twice the wavelength for exponent 1", T,
                   float, double, long double) {
    CHECK(angstrom_ratio(T(0.55L), T(0.55L), T(1.3L)) == T(1));  // exact: pow of 1
    CHECK(angstrom_ratio(T(1.1L), T(0.55L), T(0)) == T(1));      // exact: exponent 0
    CHECK_WITHIN(compare_ulp("angstrom_ratio", {}, angstrom_ratio(T(2), T(1), T(1)), 0.5L),
                 1.0L);  // pow's own ulp
    // There and back again: two results of pow, two roundoffs each, and the quotient's times the exponent.
    const T there = angstrom_ratio(T(0.44L), T(0.68L), T(1.5));
    const T back = angstrom_ratio(T(0.68L), T(0.44L), T(1.5));
    CHECK_WITHIN(compare_ulp("angstrom_ratio", {}, there * back, 1.0L), 8.0L);
}

TEST_CASE_TEMPLATE("the sun gives 1361 W/m2, 133 000 lux, and light a little warmer than white", T, float,
                   double, long double) {
    CHECK(std::fabs(total_solar_irradiance<T> - T(1361)) < T(0.5));  // the nominal 1361, rounded to a watt
    // Between the 128 klx of older works and what a black body of the sun's 5772 K gives, 93.5 lm/W: 127 klx;
    // the sun's lines take more of the ultraviolet than of the visible, so it lies above both.
    CHECK(solar_illuminance<T> > T(128e3L));
    CHECK(solar_illuminance<T> < T(134e3L));
    const vec3<T> rgb = solar_illuminance_rgb<T>;
    // The colour's digits, and 3e-5 by which color.hpp's four digits of the luminance differ from the
    // primaries'.
    CHECK_WITHIN(compare_relative("luminance", {}, luminance(rgb), solar_illuminance<T>), 1e-4L);
    CHECK(rgb.x > rgb.y);
    CHECK(rgb.y > rgb.z);
    CHECK(rgb.x / rgb.z < T(1.2L));
    // A tenth of the whole lies in 50 nm around the green channel: 93 W/m2, by hand about 1.87 x 50.
    CHECK(solar_spectral_irradiance<T>.y * 50 / total_solar_irradiance<T> ==
          doctest::Approx(0.0685).epsilon(0.01));
}

TEST_CASE_TEMPLATE("the sun's light is what its published spectrum integrates to", T, float, double,
                   long double) {
    for (const Row& row : reference("solar_light")) {
        const std::string& what = row.text("what");
        const long double expected = row.expected("expected");
        const auto check = [&](T got, long double digit) {
            // Half a unit of the last digit that the header prints, and its rounding to T.
            CHECK_WITHIN(compare_relative(what.c_str(), {}, got, expected),
                         0.5L * digit / expected + unit_roundoff<T>());
        };
        if (what == "printed_total") {
            CHECK(std::fabs(expected - 1366.1L) < 0.05L);  // what the spectrum's publisher says of it
        } else if (what == "total") {
            check(total_solar_irradiance<T>, 0.1L);
        } else if (what == "illuminance") {
            check(solar_illuminance<T>, 0.01L);
        } else if (what == "red") {
            check(solar_illuminance_rgb<T>.x, 0.01L);
        } else if (what == "green") {
            check(solar_illuminance_rgb<T>.y, 0.01L);
        } else if (what == "blue") {
            check(solar_illuminance_rgb<T>.z, 0.01L);
        } else if (what == "at_680") {
            check(solar_spectral_irradiance<T>.x, 1e-5L);
        } else if (what == "at_550") {
            check(solar_spectral_irradiance<T>.y, 1e-5L);
        } else if (what == "at_440") {
            check(solar_spectral_irradiance<T>.z, 1e-5L);
        } else {
            // A black body of 5900 K is at (0.324, 0.336); the sun's colour is close to it.
            REQUIRE((what == "chromaticity_x" || what == "chromaticity_y"));
            CHECK(std::fabs(expected - (what == "chromaticity_x" ? 0.324L : 0.334L)) < 0.003L);
        }
    }
}

TEST_CASE("the observer's table is whole: its three columns add up alike") {
    // The three functions are made to have one area, so that white of equal energy is x = y = z.
    long double sums[3] = {0, 0, 0};
    for (const Row& row : reference("inputs/cie_1931")) {
        sums[0] += row.expected("x");
        sums[1] += row.expected("y");
        sums[2] += row.expected("z");
    }
    // They agree to 4e-4 in the table of 5 nm: 21.3731, 21.3714 and 21.3786.
    CHECK(std::fabs(sums[0] - 21.3731L) < 1e-4L);  // the digits written here
    CHECK(std::fabs(sums[1] - 21.3714L) < 1e-4L);
    CHECK(std::fabs(sums[2] - 21.3786L) < 1e-4L);
}

TEST_CASE_TEMPLATE("aerosol at 550 and 1240 nm of depth 0.15 and 0.05 has 0.1083 at 700 nm", T, float, double,
                   long double) {
    // A worked example in pvlib's own tests: exponent 1.3513924317859232, result 0.10828110997681031.
    const T got = T(0.15L) * angstrom_ratio(T(0.7L), T(0.55L), T(1.3513924317859232L));
    // Their double's rounding, or our own: pow amplifies the exponent's 1.35 ln(1.27) = 0.33 and the
    // quotient's 1.35.
    CHECK_WITHIN(compare_roundoffs("angstrom_ratio", {}, got, 0.10828110997681031L, 0.1083L),
                 sizeof(T) == sizeof(long double) ? 2048.0L * 8 : 8.0L);
}

TEST_CASE_TEMPLATE("coefficients scale exactly with the unit of length", T, float, double, long double) {
    // Exact: powers of two. A formula for aerosol that leaves out the wavelength could not pass this test: it
    // has the unit of length to the minus five, which is why aerosol is the user's constant here and has no
    // function.
    const T k = 1024;
    Random random(24);
    for (int i = 0; i < 1000; ++i) {
        const T refractivity = T(random.log_uniform(1e-6, 1e-2));
        const T density = T(random.log_uniform(1e4, 1e8));
        const T wavelength = T(random.uniform(0.25, 2));
        CHECK(k * rayleigh_coefficient(refractivity, density / (k * k * k), k * wavelength) ==
              rayleigh_coefficient(refractivity, density, wavelength));
        const T visibility = T(random.log_uniform(10, 1e5));
        CHECK(k * extinction_from_visibility(k * visibility, T(0.02L)) ==
              extinction_from_visibility(visibility, T(0.02L)));
        CHECK(angstrom_ratio(k * wavelength, k * T(0.55L), T(1.3L)) ==
              angstrom_ratio(wavelength, T(0.55L), T(1.3L)));
        const vec3<T> scattering = vec3<T>(wavelength, visibility, density);
        CHECK(absorption_from_albedo(scattering * k, T(0.61L)) ==
              absorption_from_albedo(scattering, T(0.61L)) * k);
    }
}

TEST_CASE_TEMPLATE("coefficients agree with 50 digits", T, float, double, long double) {
    Worst king;
    Worst rayleigh;
    Worst visibility;
    Worst angstrom;
    Worst absorption;
    for (const Row& row : reference("spectrum")) {
        const std::string& name = row.text("function");
        const T a = row.input<T>("a");
        const T b = row.input<T>("b");
        const T c = row.input<T>("c");
        const long double expected = row.expected("expected");
        if (name == "king") {
            // 7 d / (6 - 7 d) amplifies the rounding of 7 d: 1.4 at d = 0.5, 0.13 up to 0.1.
            king.add(compare_ulp("king_factor", {{"d", a}}, king_factor(a), expected));
        } else if (name == "rayleigh") {
            rayleigh.add(compare_ulp("rayleigh_coefficient",
                                     {{"refractivity", a}, {"number_density", b}, {"wavelength", c}},
                                     rayleigh_coefficient(a, b, c), expected));
        } else if (name == "visibility") {
            visibility.add(compare_ulp("extinction_from_visibility", {{"visibility", a}, {"contrast", b}},
                                       extinction_from_visibility(a, b), expected));
        } else if (name == "angstrom") {
            // The rounded quotient is raised to the exponent.
            const long double condition =
                std::fabs(expected) * (1.0L + std::fabs(static_cast<long double>(c)));
            angstrom.add(compare_roundoffs("angstrom_ratio",
                                           {{"wavelength", a}, {"reference_wavelength", b}, {"exponent", c}},
                                           angstrom_ratio(a, b, c), expected, condition));
        } else {
            REQUIRE(name == "absorption");
            const long double albedo = b;
            const long double condition = std::fabs(expected) + static_cast<long double>(a);
            static_cast<void>(albedo);
            absorption.add(compare_roundoffs("absorption_from_albedo", {{"scattering", a}, {"albedo", b}},
                                             absorption_from_albedo(vec3<T>(a), b).y, expected, condition));
        }
    }
    king.print("against 50 digits");
    rayleigh.print("against 50 digits");
    visibility.print("against 50 digits");
    angstrom.print("against 50 digits");
    absorption.print("against 50 digits");
    CHECK_WORST(king, 4.0L + table_rounding<T>());        // the docstring's bound
    CHECK_WORST(rayleigh, 8.0L + table_rounding<T>());    // the docstring's bound
    CHECK_WORST(visibility, 2.0L + table_rounding<T>());  // log's ulp and one quotient
    CHECK_WORST(angstrom, 3.0L + table_rounding<T>());    // the quotient within the condition, pow's ulp
    CHECK_WORST(absorption, 3.0L + table_rounding<T>());  // difference, quotient, product
}

TEST_CASE_TEMPLATE("no refractivity scatters nothing, and a number density of 0 divides by zero", T, float,
                   double, long double) {
    CHECK(rayleigh_coefficient(T(0), T(2.5e7L), T(0.55L)) == T(0));
    CHECK(std::isinf(rayleigh_coefficient(T(3e-4L), T(0), T(0.55L))));
    CHECK(std::isinf(extinction_from_visibility(T(0), T(0.02L))));
    CHECK(std::isinf(absorption_from_albedo(vec3<T>(T(1)), T(0)).x));
    CHECK(absorption_from_albedo(vec3<T>(T(0)), T(0.5)) == vec3<T>(T(0)));
}

TEST_SUITE_END();
