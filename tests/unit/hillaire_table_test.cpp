#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/hillaire_table.hpp>

#include <cmath>
#include <cstdio>

#include "converted.hpp"
#include "extremes.hpp"
#include "promises.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"

using namespace airlight;
using namespace airlight_test;

namespace {

/// Hillaire's effort.
template <typename Scene = DefaultScene, typename T>
vec3<T> texel(const Atmosphere<T>& air, T altitude, T mu_s) {
    return hillaire_texel<T, Scene>(air, altitude, mu_s, 8, 4, 20);
}

}  // namespace

TEST_SUITE_BEGIN("hillaire_table");

TEST_CASE_TEMPLATE("the cosine of a share of half a turn", T, float, double) {
    CHECK(cosine_of_half_turn(T(0.5)) == T(0));  // exact: an odd polynomial
    Worst worst;
    for (int i = 0; i <= 1000; ++i) {
        const T share = T(i) / T(1000);
        const long double expected = std::cos(3.14159265358979323846264338327950288L * share);
        worst.add(compare_roundoffs("cosine_of_half_turn", {{"share", share}}, cosine_of_half_turn(share),
                                    expected, 1.0L + 7e-12L / (std::numeric_limits<T>::epsilon() / 2)));
        CHECK(cosine_of_half_turn(T(1) - share) ==
              doctest::Approx(-cosine_of_half_turn(share)).epsilon(1e-6));
    }
    CHECK_WORST(worst, 8.0L);  // the docstring's; the series' remainder stands in the condition
}

TEST_CASE_TEMPLATE("without air half of all directions see the lit ground", T, float, double) {
    Atmosphere<T> bare = earth<T>();
    bare.rayleigh_scattering = bare.mie_scattering = bare.mie_absorption = bare.ozone_absorption =
        vec3<T>(T(0));
    bare.ground_albedo = vec3<T>(T(1), T(0.5), T(0));
    const T mu_s = T(0.75);
    const vec3<T> psi = texel(bare, T(0), mu_s);
    // albedo mu_s / (2 pi); the sum of 32 directions, and the sun's height over the centre.
    CHECK_WITHIN(compare_ulp("hillaire_texel", {}, psi.x, 0.75L / 6.28318530717958647692528676655900577L),
                 64.0L);
    CHECK_WITHIN(compare_ulp("hillaire_texel", {}, psi.y, 0.375L / 6.28318530717958647692528676655900577L),
                 64.0L);
    CHECK(psi.z == T(0));
    CHECK(texel(bare, T(0), T(-0.1L)) == vec3<T>(T(0)));  // exact: no sun on the ground
}

TEST_CASE_TEMPLATE("light that the ground reflects comes in proportion to its albedo", T, float, double) {
    Atmosphere<T> air = earth<T>();
    const auto with_albedo = [&](T albedo) {
        air.ground_albedo = vec3<T>(albedo);
        return texel(air, T(500), T(0.5)).y;
    };
    const T none = with_albedo(T(0));
    const T half = with_albedo(T(0.5));
    const T all = with_albedo(T(1));
    CHECK(half > none);
    CHECK_WITHIN(compare_relative("hillaire_texel", {}, all - half, static_cast<long double>(half - none)),
                 400.0L * static_cast<long double>(std::numeric_limits<T>::epsilon()));  // sums of 640 terms
}

TEST_CASE_TEMPLATE("the light does not depend on the unit of length", T, float, double) {
    const Atmosphere<T> metres = earth<T>();
    const Atmosphere<T> other = rescaled(metres, T(1) / T(1024));
    for (const T mu_s : {T(1), T(0.2L), T(-0.05L)}) {
        const vec3<T> a = texel(metres, T(3000), mu_s);
        const vec3<T> b = texel(other, T(3000) / T(1024), mu_s);
        CHECK(a == b);  // exact: a power of two
    }
}

TEST_CASE_TEMPLATE("a term that is off equals its coefficients set to zero", T, float, double) {
    Atmosphere<T> clear = earth<T>();
    clear.mie_scattering = clear.mie_absorption = vec3<T>(T(0));
    Atmosphere<T> no_ozone = earth<T>();
    no_ozone.ozone_absorption = vec3<T>(T(0));
    for (const T mu_s : {T(0.9L), T(0.1L), T(-0.05L)}) {
        CHECK(texel<NoMie>(earth<T>(), T(1e3L), mu_s) == texel(clear, T(1e3L), mu_s));  // exact: adds zeros
        CHECK(texel<NoOzone>(earth<T>(), T(1e3L), mu_s) == texel(no_ozone, T(1e3L), mu_s));
    }
}

TEST_CASE("thin air: twice the gas, twice the twice-scattered light") {
    Atmosphere<double> air = earth<double>();
    air.mie_scattering = air.mie_absorption = air.ozone_absorption = air.ground_albedo = vec3<double>(0);
    const auto light = [&](double share) {
        air.rayleigh_scattering = vec3<double>(share * 1e-6);
        return texel(air, 1e3, 0.5).x;
    };
    // Depths of 1e-5 and less: the next order is as small.
    CHECK(std::fabs(light(2e-3) / light(1e-3) / 2 - 1) <= 1e-4);
}

TEST_CASE("64 directions and 20 steps are Hillaire's; more of both change little by day") {
    const Atmosphere<double> air = earth<double>();
    double worst = 0;
    for (const double altitude : {0.0, 1e3, 5e3, 1e4}) {
        for (const double mu_s : {1.0, 0.5, 0.1}) {
            const vec3<double> his = texel(air, altitude, mu_s);
            const vec3<double> fine = hillaire_texel<double>(air, altitude, mu_s, 24, 12, 160);
            const vec3<double> finer = hillaire_texel<double>(air, altitude, mu_s, 24, 12, 320);
            for (int i = 0; i < 3; ++i) {
                worst = std::fmax(worst, std::fabs(his[i] / fine[i] - 1));
                CHECK(std::fabs(fine[i] / finer[i] - 1) <= 0.02);  // so that fine may judge
            }
        }
    }
    std::printf(
        "hillaire_texel: 64 directions, 20 steps within %.1f %% of 576 directions, 160 steps by day\n",
        100 * worst);
    CHECK(worst <= 0.25);  // printed: 0.21, low suns seen from 10 km
}

TEST_CASE("the series gains what it must and no more") {
    // White mist a hundred optical depths thick: all that scatters stays, and the series would not end.
    Atmosphere<double> mist = earth<double>();
    mist.rayleigh_scattering = vec3<double>(100 / mist.rayleigh_scale_height);
    mist.mie_scattering = mist.mie_absorption = mist.ozone_absorption = vec3<double>(0);
    mist.ground_albedo = vec3<double>(1);
    for (const double altitude : {0.0, 1e3, 2e4, 4e4, 1e5}) {
        const vec3<double> psi = texel(mist, altitude, 1.0);
        CHECK_UNARY(is_amount(psi));
        CHECK(psi.x < 1.0);  // a white surface in the sun has 1 / pi
    }
    // An absorbing one gains next to nothing: f < 1e-2.
    Atmosphere<double> soot = earth<double>();
    soot.rayleigh_scattering = vec3<double>(0);
    soot.mie_absorption = 1e3 * soot.mie_scattering;
    const vec3<double> dark = texel(soot, 1e3, 0.5);
    CHECK_UNARY(is_amount(dark));
    CHECK(dark.x < 1e-3);
}

TEST_CASE_TEMPLATE("every atmosphere, altitude and sun gives an amount of light", T, float, double) {
    Random random(41);
    for (int i = 0; i < 3000; ++i) {
        const Atmosphere<T> air = any_atmosphere<T>(random);
        const T altitude = any_altitude<T>(random, air);
        const T mu_s = cosine<T>(random);
        const vec3<T> psi = hillaire_texel<T>(air, altitude, mu_s, 3, 2, 5);
        INFO("h ", double(altitude), " mu_s ", double(mu_s), " H ", double(air.rayleigh_scale_height), " R ",
             double(air.ground_radius), " top ", double(air.top_altitude));
        CHECK_UNARY(is_amount(psi));
    }
    CHECK(hillaire_texel<T>(earth<T>(), T(0), T(1), 0, 4, 20) == vec3<T>(T(0)));
    CHECK_UNARY(is_amount(hillaire_texel<T>(earth<T>(), T(0), T(1), 8, 4, 0)));
    CHECK_UNARY(is_amount(hillaire_texel<T>(earth<T>(), T(0), T(1), -1, -1, -1)));
}

TEST_SUITE_END();
