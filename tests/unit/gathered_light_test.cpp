#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/gathered_light.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

struct Bright {
    template <typename T>
    DiffuseLight<T> operator()(T, T) const {
        return even_light(vec3<T>(T(1)));
    }
};
struct BrightGround {
    template <typename T>
    vec3<T> operator()(T) const {
        return vec3<T>(pi<T>);
    }
};

}  // namespace

TEST_SUITE_BEGIN("gathered_light");

TEST_CASE("between a white ground and thick air that absorb nothing, even light stays as it is") {
    // The furnace: radiance 1 from all sides, irradiance pi on the ground.
    Atmosphere<double> air = earth<double>();
    air.rayleigh_scattering = vec3<double>(1e-3);  // optical depth 8
    air.mie_scattering = vec3<double>(1e-3);
    air.mie_absorption = air.ozone_absorption = vec3<double>(0.0);
    air.ground_albedo = vec3<double>(1.0);
    const GatheredLight<double> got =
        gathered_light<double, Nodes<16>>(air, 100.0, 0.4, false, Bright{}, BrightGround{});
    // 16 nodes of a ray of optical depth 8, 32 x 16 directions (measured: 2e-3).
    const double close = 5e-3;
    CHECK(got.light.mean.x == doctest::Approx(1).epsilon(close));
    CHECK(got.irradiance.down.x == doctest::Approx(pi<double>).epsilon(close));
    CHECK(got.irradiance.up.x == doctest::Approx(pi<double>).epsilon(close));
    CHECK(std::fabs(got.light.vertical.x) <= close);
    CHECK(std::fabs(got.light.slanted.x) <= close);
    CHECK(std::fabs(got.light.across.x) <= close);
    CHECK(std::fabs(got.irradiance.sunward.x) <= close * 4 * pi<double>);
    for (const vec3<double>& side : {got.light.aerosol_up, got.light.aerosol_down, got.light.aerosol_sunward,
                                     got.light.aerosol_away, got.light.aerosol_aside}) {
        CHECK(side.x == doctest::Approx(1).epsilon(close));
    }
}

TEST_CASE_TEMPLATE("narrow lobes of aerosol lose none of even light between few directions", T, float,
                   double) {
    Atmosphere<T> air = earth<T>();
    air.rayleigh_scattering = vec3<T>(T(1e-3L));
    air.mie_absorption = air.ozone_absorption = vec3<T>(T(0));
    air.ground_albedo = vec3<T>(T(1));
    for (const double g : {0.8, 0.9, 0.95, 0.99, -0.95}) {
        air.mie_g = T(g);
        const GatheredLight<T> got = gathered_light<T>(air, T(100), T(0.4L), false, Bright{}, BrightGround{});
        CAPTURE(g);
        for (const vec3<T>& side : {got.light.aerosol_up, got.light.aerosol_down, got.light.aerosol_sunward,
                                    got.light.aerosol_away, got.light.aerosol_aside}) {
            // The ground's light through the air, by column and by legs, in float.
            CHECK(std::fabs(static_cast<double>(side.x) - 1) <= 1e-3);
        }
    }
}

TEST_CASE("the first order on the ground without air is the sunlit ground: nothing from above") {
    Atmosphere<double> air = earth<double>();
    air.rayleigh_scattering = air.mie_scattering = air.mie_absorption = air.ozone_absorption =
        vec3<double>(0.0);
    air.ground_albedo = vec3<double>(0.5);
    const GatheredLight<double> got = gathered_light<double>(air, 0.0, 0.5, true);
    CHECK(got.irradiance.down.x == 0);
    // E_up = pi L = albedo E_sun mu_s; the quadrature of z dz is exact, the ground's sun is as high
    // everywhere that an eye at its level sees.
    CHECK(got.irradiance.up.x == doctest::Approx(0.25).epsilon(1e-12));
    CHECK(got.light.mean.x == doctest::Approx(0.25 / pi<double> / 2).epsilon(1e-12));  // from half the sphere
}

TEST_CASE_TEMPLATE("every order is finite and not negative where it has to be, for any air and sun", T, float,
                   double) {
    Random random(95);
    for (int i = 0; i < 60; ++i) {
        Atmosphere<T> air = i % 3 == 0 ? mars<T>() : earth<T>();
        if (i % 4 == 1) {
            air.rayleigh_scattering *= T(30);
        }
        if (i % 4 == 2) {
            air.rayleigh_scattering = vec3<T>(T(0));
        }
        if (i % 4 == 3) {
            air.mie_scattering = air.mie_absorption = vec3<T>(T(0));
        }
        const T altitude = T(random.unit()) * air.top_altitude * T(i % 5 == 0 ? 0 : 1);
        const T mu_s = i % 7 == 0 ? T(1) : T(2 * random.unit() - 1);
        const GatheredLight<T> got =
            gathered_light<T, Nodes<4>>(air, altitude, mu_s, i % 2 == 0, Bright{}, BrightGround{});
        for (int c = 0; c < 3; ++c) {
            CAPTURE(exact(altitude));
            CAPTURE(exact(mu_s));
            CHECK(got.light.mean[c] >= T(0));  // false for NaN too
            CHECK(got.light.aerosol_up[c] >= T(0));
            CHECK(got.light.aerosol_sunward[c] >= T(0));
            CHECK(got.irradiance.down[c] >= T(0));
            CHECK(got.irradiance.up[c] >= T(0));
            CHECK(std::isfinite(static_cast<double>(got.light.across[c] + got.light.slanted[c] +
                                                    got.light.vertical[c] + got.irradiance.sunward[c])));
        }
    }
}

TEST_CASE_TEMPLATE("an order that halves counts twice, one that does not fade twenty times", T, float,
                   double) {
    CHECK(gain_of_last_order(T(2), T(1)) == T(2));  // exact: halves
    CHECK(gain_of_last_order(T(1), T(0)) == T(1));
    CHECK(gain_of_last_order(T(0), T(1)) == T(1));
    CHECK_WITHIN(compare_ulp("gain_of_last_order", {}, gain_of_last_order(T(1), T(1)), 20.0L),
                 24.0L);  // 1 - 0.95 leaves 20 roundoffs of 0.95
}

TEST_CASE("light adds up member by member") {
    const vec3<double> one(1.0);
    const GatheredLight<double> a{even_light(one), {one, 2.0 * one, 3.0 * one}};
    const GatheredLight<double> sum = sum_of_light(a, vec3<double>(0.5, 0.25, 2.0), a);
    CHECK(sum.light.mean == vec3<double>(1.5, 1.25, 3.0));  // exact: binary fractions
    CHECK(sum.light.aerosol_aside == vec3<double>(1.5, 1.25, 3.0));
    CHECK(sum.irradiance.sunward == vec3<double>(4.5, 3.75, 9.0));
}

TEST_SUITE_END();
