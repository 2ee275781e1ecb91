#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/sun.hpp>

#include "promises.hpp"
#include "quadrature.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
vec3<T> away_from_z(T sine) {
    return vec3<T>(sine, T(0), std::sqrt((1 - sine) * (1 + sine)));
}

/// Irradiance of a channel of the disc on a surface that faces it: its radiance times the cosine, ring by
/// ring.
long double irradiance(const SunDisc<double>& disc, int channel) {
    const vec3<double> to_sun(0, 0, 1);
    const long double rim = disc.sin_radius;
    const long double edge = disc.sin_edge;
    // The cosine times the ring's width is d(sine^2) / 2.
    const auto ring = [&](long double square) {
        return static_cast<long double>(
            sun_radiance(disc, away_from_z(std::sqrt(double(square))), to_sun)[channel]);
    };
    const long double spread = edge * (2 * rim + edge);
    const long double kink = std::fabs(rim * rim - spread);
    const long double end = rim * rim + spread;
    return pi<long double> *
           (integrate(ring, 0, kink, 1e-12L) + (kink < end ? integrate(ring, kink, end, 1e-12L) : 0));
}

/// The mean over the disc of what transmittance_to_space lets through, in level strips.
vec3<double> mean_over_disc(const Atmosphere<double>& air, double altitude, double elevation, double radius) {
    vec3<double> sum(0);
    double whole = 0;
    const int strips = 4000;
    for (int i = 0; i < strips; ++i) {
        const double y = -1 + 2 * (i + 0.5) / strips;
        const double width = std::sqrt(1 - y * y);
        sum += width * transmittance_to_space(air, altitude, std::sin(elevation + y * radius));
        whole += width;
    }
    return sum / whole;
}

}  // namespace

TEST_SUITE_BEGIN("sun");

TEST_CASE_TEMPLATE("the sun covers 6.79e-5 sr, half the sky 2 pi", T, float, double, long double) {
    // pi (0.00465047)^2 = 6.7943e-5, and a quarter of its square more.
    CHECK_WITHIN(compare_relative("disc_solid_angle", {}, disc_solid_angle(solar_sin_radius<T>), 6.7943e-5L),
                 2e-5L);  // the digits written here
    CHECK_WITHIN(
        compare_ulp("disc_solid_angle", {{"sin_radius", 1}}, disc_solid_angle(T(1)), 2 * pi<long double>),
        2.0L);
    // 0.2665 degrees, 959.2 seconds of arc.
    const long double seconds =
        std::asin(static_cast<long double>(solar_sin_radius<T>)) / pi<long double> * 180 * 3600;
    CHECK(std::fabs(seconds - 959.2L) < 0.1L);
    CHECK(disc_solid_angle(T(0)) == T(0));
}

TEST_CASE("the disc gives a surface that faces it unit irradiance, however its rim is spread") {
    for (const double sine : {solar_sin_radius<double>, 1e-4, 0.05, 0.7}) {
        for (const double edge : {0.0, 1e-3, 0.02, 0.3, 1.0, 2.0}) {
            if ((1 + edge) * sine > 0.99) {
                continue;  // the rim would lie behind the eye's plane
            }
            SunDisc<double> disc = solar_disc<double>();
            disc.sin_radius = sine;
            disc.sin_edge = edge * sine;
            for (int channel = 0; channel < 3; ++channel) {
                // 1e-10: the series of windowed_power; the rest the quadrature's, which meets the rim's root.
                CHECK_WITHIN(compare_relative("irradiance", {{"sin_radius", sine}, {"edge", edge}},
                                              double(irradiance(disc, channel)), 1.0L),
                             2e-9L);
            }
        }
    }
}

TEST_CASE_TEMPLATE("the middle of the disc is 1 + a / 2 times the mean, and the rim is dark and red", T,
                   float, double, long double) {
    const SunDisc<T> disc = solar_disc<T>();
    const vec3<T> to_sun(T(0), T(0), T(1));
    const vec3<T> centre = sun_radiance(disc, to_sun, to_sun);
    const T mean = disc_radiance(disc.sin_radius);
    for (int k = 0; k < 3; ++k) {
        CHECK_WITHIN(compare_ulp("sun_radiance", {}, centre[k] / mean,
                                 1 + static_cast<long double>(disc.limb_exponents[k]) / 2),
                     4.0L);  // two quotients and a product
    }
    // At 0.8 of the radius the cosine on the sun's sphere is 0.6.
    const vec3<T> outer = sun_radiance(disc, away_from_z(T(0.8L) * disc.sin_radius), to_sun);
    for (int k = 0; k < 3; ++k) {
        const long double expected = std::pow(0.6L, static_cast<long double>(disc.limb_exponents[k]));
        // The angle's square is rounded, and 1 - 0.64 makes 1.8 of that.
        CHECK_WITHIN(compare_ulp("sun_radiance", {}, outer[k] / centre[k], expected), 16.0L);
    }
    CHECK(outer.x / outer.z > centre.x / centre.z);
    // Past the rim, and on the other side of the sky, where the sine is small again.
    CHECK(sun_radiance(disc, away_from_z(T(1.001L) * disc.sin_radius), to_sun) == vec3<T>(T(0)));
    CHECK(sun_radiance(disc, -to_sun, to_sun) == vec3<T>(T(0)));
}

TEST_CASE_TEMPLATE("the exponents follow the published straight line over 1 / wavelength", T, float, double,
                   long double) {
    const long double wavelengths[] = {0.68L, 0.55L, 0.44L};
    for (int k = 0; k < 3; ++k) {
        CHECK_WITHIN(compare_relative("limb_exponents", {{"wavelength", wavelengths[k]}},
                                      solar_disc<T>().limb_exponents[k], 0.292L / wavelengths[k] - 0.023L),
                     0.03L);  // what the docstring says of it
    }
}

TEST_CASE_TEMPLATE("a spread rim goes from all to nothing over a pixel, without a step", T, float, double,
                   long double) {
    SunDisc<T> disc = solar_disc<T>();
    disc.sin_edge = T(0.1L) * disc.sin_radius;
    const vec3<T> to_sun(T(0), T(0), T(1));
    CHECK(sun_radiance(disc, away_from_z(T(1.1001L) * disc.sin_radius), to_sun) == vec3<T>(T(0)));
    CHECK(sun_radiance(disc, away_from_z(T(1.099L) * disc.sin_radius), to_sun).y > T(0));
    T before = sun_radiance(disc, to_sun, to_sun).y;
    const T centre = before;
    for (int i = 1; i <= 1200; ++i) {
        const T now = sun_radiance(disc, away_from_z(disc.sin_radius * T(i) / T(1000)), to_sun).y;
        // 2048 roundoffs: the angle's rounding at the rim, where a window of a tenth amplifies it tenfold.
        CHECK(now <= before * (1 + 2048 * T(unit_roundoff<T>())));
        CHECK(before - now <=
              T(0.015L) * centre);  // the window is 0.2 wide, 1 / 200 of the height per step, thrice
        before = now;
    }
    CHECK(before == T(0));
}

TEST_CASE_TEMPLATE("solid angle, limb, middle and lobe agree with 50 digits", T, float, double, long double) {
    Worst angles;
    Worst limbs;
    Worst middles;
    Worst lobes;
    for (const Row& row : reference("sun")) {
        const T a = row.input<T>("a");
        const T b = row.input<T>("b");
        const T c = row.input<T>("c");
        const long double expected = row.expected("expected");
        const long double condition = row.expected("condition");
        const std::string& name = row.text("function");
        if (name == "solid_angle") {
            angles.add(compare_roundoffs("disc_solid_angle", {{"sin_radius", a}}, disc_solid_angle(a),
                                         expected, condition));
        } else if (name == "limb") {
            // The series' 1e-9, in the unit of rounding.
            limbs.add(compare_roundoffs("limb_darkening", {{"square", a}, {"exponent", b}, {"spread", c}},
                                        limb_darkening(a, b, c), expected,
                                        condition + 1e-9L / unit_roundoff<T>() / 4));
        } else if (name == "middle") {
            // The fit's 1.5e-9, as for segments, in the unit of rounding.
            middles.add(compare_roundoffs("visible_middle", {{"gap", a}}, visible_middle(a), expected,
                                          condition + 1.5e-9L / unit_roundoff<T>() / 8));
        } else {
            REQUIRE(name == "lobe");
            lobes.add(compare_roundoffs("elek_sun_lobe", {{"cos_theta", a}, {"g", b}}, elek_sun_lobe(a, b),
                                        expected, condition));
        }
    }
    angles.print("against 50 digits");
    limbs.print("against 50 digits, the series counted as rounding");
    middles.print("against 50 digits, the fit counted as rounding");
    lobes.print("against 50 digits");
    CHECK_WORST(angles, 6.0L + table_rounding<T>());   // the docstring's
    CHECK_WORST(limbs, 4.0L + table_rounding<T>());    // the docstring's
    CHECK_WORST(middles, 8.0L + table_rounding<T>());  // the docstring's
    CHECK_WORST(lobes, 8.0L + table_rounding<T>());    // the docstring's
}

TEST_CASE("the lobe that draws the Elek notes' sun holds half a percent of the sun's light") {
    // Our reading of it: (1 - g)^2 in place of 1 - g^2 leaves (1 - g) / (1 + g) of a phase function's light.
    const long double g = 0.99L;
    const long double sphere = integrate_sphere([&](long double c) {
        return (1 - g) * (1 - g) / (4 * pi<long double> * std::pow(1 + g * g - 2 * g * c, 1.5L));
    });
    CHECK(std::fabs(sphere - 0.005025L) < 5e-7L);           // half a unit of the last digit
    CHECK(std::fabs(sphere - (1 - g) / (1 + g)) < 1e-12L);  // the quadrature's
    const long double ours =
        integrate_sphere([&](long double c) { return elek_sun_lobe(c, elek_sun_g<long double>); });
    CHECK(std::fabs(ours - sphere) < 1e-12L);  // the same, by quadrature
    CHECK(elek_sun_g<double> == 0.99);
    CHECK(elek_sun_scale<double> == 0.003);
    // 0.003 / (4 pi 0.01): times its scale its middle is at 0.024 where a disc of unit irradiance is at 18
    // 400.
    CHECK(elek_sun_scale<double> * elek_sun_lobe(1.0, 0.99) == doctest::Approx(0.02387).epsilon(1e-3));
    CHECK(sun_radiance(solar_disc<double>(), vec3<double>(0, 0, 1), vec3<double>(0, 0, 1)).y ==
          doctest::Approx(18422).epsilon(1e-3));
}

TEST_CASE_TEMPLATE("Leenman's sun is 3 within 1.15 degrees", T, float, double, long double) {
    CHECK(leenman_sun(T(1)) == T(3));
    CHECK(leenman_sun(T(std::cos(1.145L * pi<long double> / 180))) == T(3));
    CHECK(leenman_sun(T(std::cos(1.147L * pi<long double> / 180))) == T(0));
    CHECK(leenman_sun(T(-1)) == T(0));
    CHECK(leenman_sun(std::numeric_limits<T>::quiet_NaN()) == T(0));
}

TEST_CASE("sunlight is the mean over the disc, from the ground to orbit") {
    const Atmosphere<double> air = earth<double>();
    const double sun = solar_sin_radius<double>;
    Worst ground;
    Worst orbit;
    for (const double altitude : {0.0, 500.0, 1e4, 4e5, 3.6e7}) {
        const double horizon = -std::acos(air.ground_radius / (air.ground_radius + altitude));
        for (double gap = -0.95; gap < 20; gap += 0.15) {
            const double elevation = horizon + gap * sun;
            const vec3<double> expected = mean_over_disc(air, altitude, elevation, std::asin(sun));
            const vec3<double> got = sunlight(air, altitude, std::sin(elevation), sun);
            for (int k = 0; k < 3; ++k) {
                Comparison compared = compare_relative(
                    "sunlight", {{"altitude", altitude}, {"gap", gap}, {"channel", double(k)}}, got[k],
                    expected[k]);
                compared.error *= expected[k];  // of full sunlight
                (altitude < 2e4 ? ground : orbit).add(compared);
            }
        }
    }
    ground.print("against the mean over the disc, from the ground");
    orbit.print("against the mean over the disc, from orbit");
    CHECK_WORST(ground, 0.0015L);  // the docstring's
    CHECK_WORST(orbit, 0.11L);     // the docstring's
}

TEST_CASE_TEMPLATE("the sun sets within its diameter, without a step", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const T sun = solar_sin_radius<T>;
    for (const T altitude : {T(0), T(2), T(1e4L), T(4e5L)}) {
        const T dip =
            -std::sqrt(altitude * (2 * air.ground_radius + altitude)) / (air.ground_radius + altitude);
        const T cosine = air.ground_radius / (air.ground_radius + altitude);
        T before = sunlight(air, altitude, dip + 2 * sun * cosine, sun).x;
        CHECK(before > T(0));
        for (int i = 0; i <= 400; ++i) {
            const T mu = dip + sun * cosine * (T(2) - T(4 * i) / T(400));
            const T now = sunlight(air, altitude, mu, sun).x;
            // A hundredth of the radius: of its light a disc loses at most 2 / pi of that, and the air dims
            // it.
            CHECK(std::fabs(before - now) <= T(0.01L));
            before = now;
        }
        CHECK(before == T(0));
    }
}

TEST_CASE_TEMPLATE("a sun without size is there or not, and high up its size does not matter", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    Random random(321);
    for (int i = 0; i < 3000; ++i) {
        const T altitude = T(random.log_uniform(1, 1e6));
        const T mu = T(random.uniform(-1, 1));
        const T gap = occultation_by_ground(air.ground_radius, altitude, mu, T(1)).gap;
        if (std::fabs(gap) < T(1e-5L)) {
            continue;  // on the edge both may be right
        }
        CHECK(sunlight(air, altitude, mu, T(0)) == transmittance_to_space(air, altitude, mu));  // exact
        if (mu > T(0.1L)) {
            CHECK(sunlight(air, altitude, mu, solar_sin_radius<T>) ==
                  transmittance_to_space(air, altitude, mu));
        }
        CHECK(is_share(sunlight(air, altitude, mu, T(random.unit()))));
        // Without the planet's shadow the ground hides nothing.
        CHECK(sunlight<T, NoShadow>(air, altitude, mu, T(0.1L)) ==
              transmittance(air, altitude, mu, no_surface<T>()));
    }
}

TEST_SUITE_END();
