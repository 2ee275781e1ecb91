#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/constants.hpp>
#include <airlight/transmittance.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
void check_same(const vec3<T>& a, const vec3<T>& b) {
    for (int i = 0; i < 3; ++i) {
        CHECK_EQUAL(compare_ulp("transmittance", {{"channel", T(i)}}, a[i], b[i]));
    }
}

template <typename T>
void check_share(const vec3<T>& a) {
    for (int i = 0; i < 3; ++i) {
        CHECK_UNARY(a[i] >= T(0) && a[i] <= T(1));
    }
}

}  // namespace

TEST_SUITE_BEGIN("transmittance");

TEST_CASE_TEMPLATE("an optical depth of ln 2 halves the light", T, float, double, long double) {
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scale_height = T(1e30L);
    planet.rayleigh_scattering = vec3<T>(T(1e-4L), T(2e-4L), T(0));
    planet.mie_scattering = planet.mie_absorption = planet.ozone_absorption = vec3<T>(T(0));
    const T ln2 = T(0.693147180559945309417232121458176568L);
    const vec3<T> left = transmittance<T>(planet, T(1000), T(1), ln2 * 10000);
    // The depth's 4 ulp, and its own rounding, times the depth; exp's ulp.
    CHECK_WITHIN(compare_roundoffs("transmittance", {}, left.x, 0.5L, 0.5L * (1 + 0.693L)), 8.0L);
    CHECK_WITHIN(compare_roundoffs("transmittance", {}, left.y, 0.25L, 0.25L * (1 + 1.386L)), 8.0L);
    CHECK(left.z == T(1));  // exact: exp(0)
}

TEST_CASE_TEMPLATE("transmittance is exp of minus the optical depth, never the depth itself", T, float,
                   double, long double) {
    // Our choice of words where a source swaps them.
    Random random(111);
    for (int i = 0; i < 300; ++i) {
        const T h = T(random.log_uniform(1, 1e5));
        const T mu = T(random.uniform(-1, 1));
        const T d = T(random.log_uniform(1, 1e6));
        const vec3<T> depth = optical_depth<T>(earth<T>(), h, mu, d);
        check_same(transmittance<T>(earth<T>(), h, mu, d),
                   vec3<T>(std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)));
    }
}

TEST_CASE_TEMPLATE("the mean of what passes along a step is what it stops over its depth", T, float, double,
                   long double) {
    Random random(113);
    Worst worst;
    for (int i = 0; i < 2000; ++i) {
        const T depth = T(random.log_uniform(1e-12, 1e3));
        const vec3<T> depths(depth, T(0), T(0.5) * depth);
        const vec3<T> mean = mean_passed(depths, glm::exp(-depths));
        const long double expected = -std::expm1(-static_cast<long double>(depth)) / depth;
        worst.add(compare_relative("mean_passed", {{"depth", depth}}, mean.x, expected));
        CHECK(mean.y == T(1));  // exact: the series at 0
    }
    // The docstring's: the series where it ends, and float's roundoff over a depth of 0.03.
    CHECK_WORST(worst, 2e-6L + 64 * static_cast<long double>(std::numeric_limits<T>::epsilon()) / 2);
    const T infinite = std::numeric_limits<T>::infinity();
    CHECK(mean_passed(vec3<T>(infinite), vec3<T>(T(0))) == vec3<T>(T(0)));  // exact: 1 / infinity
}

TEST_CASE_TEMPLATE("transmittance is a share for every ray, and less light passes a longer way", T, float,
                   double, long double) {
    Random random(112);
    for (int i = 0; i < 2000; ++i) {
        const T h = T(random.uniform(-1e4, 3e5));
        const T mu = i % 5 == 0 ? T(i % 3 - 1) : T(random.uniform(-1, 1));
        const T d = i % 7 == 0 ? no_surface<T>() : T(random.log_uniform(1e-6, 1e8));
        check_share(transmittance<T>(earth<T>(), h, mu, d));
        check_share(transmittance_to_space<T>(earth<T>(), h, mu));
        check_share(transmittance_to_space<T, NoShadow>(leenman_earth<T>(), h, mu));
    }
    check_same(transmittance<T>(earth<T>(), T(5), T(0.25), T(0)), vec3<T>(T(1)));  // exact: exp(0)
}

TEST_CASE_TEMPLATE("thin air lets all through but its depth, thick air nothing", T, float, double,
                   long double) {
    Atmosphere<T> thin = earth<T>();
    thin.rayleigh_scattering *= T(1e-3L);
    thin.mie_scattering *= T(1e-3L);
    thin.mie_absorption *= T(1e-3L);
    thin.ozone_absorption *= T(1e-3L);
    const vec3<T> depth = optical_depth<T>(thin, T(0), T(1), no_surface<T>());
    const vec3<T> left = transmittance_to_space<T>(thin, T(0), T(1));
    for (int i = 0; i < 3; ++i) {
        // 1 - tau + tau^2 / 2: the modelling error of stopping after tau is tau^2 / 2 < 4e-8, rounding comes
        // on top.
        const long double model = static_cast<long double>(depth[i]) * depth[i] / 2;
        CHECK(std::fabs(static_cast<long double>(left[i]) - (1 - static_cast<long double>(depth[i]))) <=
              model + 2 * unit_roundoff<T>());
    }
    Atmosphere<T> thick = earth<T>();
    thick.rayleigh_scattering = vec3<T>(T(10));
    check_same(transmittance_to_space<T>(thick, T(0), T(1)), vec3<T>(T(0)));  // exact: exp underflows
}

TEST_CASE_TEMPLATE("transmittances do not depend on the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two
    const Atmosphere<T> scaled = rescaled(earth<T>(), k);
    Random random(113);
    for (int i = 0; i < 300; ++i) {
        const T h = T(random.log_uniform(0.1, 1e6));
        const T mu = T(random.uniform(-1, 1));
        const T d = T(random.log_uniform(1, 1e6));
        check_same(transmittance<T>(scaled, k * h, mu, k * d), transmittance<T>(earth<T>(), h, mu, d));
        check_same(transmittance_to_space<T>(scaled, k * h, mu),
                   transmittance_to_space<T>(earth<T>(), h, mu));
        CHECK(behind_planet(k * T(6371000), k * h, mu) == behind_planet(T(6371000), h, mu));
    }
}

TEST_CASE_TEMPLATE("behind the planet there is no light: the shadow is explicit", T, float, double,
                   long double) {
    // Our reading of a source without a planet test on the light ray: there the density under the ground
    // grows until float overflows, and with a coefficient of 0 it becomes NaN.
    const T radius = earth<T>().ground_radius;
    CHECK(behind_planet(radius, T(0), T(-1)));
    CHECK(behind_planet(radius, T(0), T(-1e-3L)));
    CHECK(behind_planet(radius, T(1000), T(-0.1L)));
    CHECK_FALSE(behind_planet(radius, T(0), T(1)));
    CHECK_FALSE(behind_planet(radius, T(1000), T(-0.01L)));  // the horizon of 1 km lies at -0.0177
    CHECK(behind_planet(radius, T(1000), T(-0.018L)));
    check_same(transmittance_to_space<T>(earth<T>(), T(0), T(-0.5)), vec3<T>(T(0)));
    const Atmosphere<T> vacuum = airless(earth<T>());
    for (const T mu : {T(-1), T(-0.3L), T(-1e-4L), T(0), T(1)}) {
        const bool dark = behind_planet(radius, T(0), mu);
        check_same(transmittance_to_space<T>(vacuum, T(0), mu), vec3<T>(dark ? T(0) : T(1)));
        check_same(transmittance_to_space<T, NoShadow>(vacuum, T(0), mu),
                   vec3<T>(T(1)));  // 0 times a finite column
    }
}

TEST_CASE_TEMPLATE("the horizon is where the ray touches the ground: sine R / (R + h)", T, float, double,
                   long double) {
    Random random(114);
    for (int i = 0; i < 5000; ++i) {
        const T radius = T(random.log_uniform(1e3, 7e7));
        const T h = radius * T(random.log_uniform(1e-4, 10));
        const T mu = T(-random.unit());
        const long double sine =
            std::sqrt((1 - static_cast<long double>(mu)) * (1 + static_cast<long double>(mu)));
        const long double gap = radius - (static_cast<long double>(radius) + h) * sine;
        const long double condition =
            radius * (1 - sine) + h * sine + (static_cast<long double>(radius) + h) * mu * mu / sine;
        if (std::fabs(gap) > 3 * unit_roundoff<T>() * condition) {  // the docstring's bound
            CHECK_UNARY(behind_planet(radius, h, mu) == (gap > 0));
        }
    }
}

TEST_CASE_TEMPLATE("exactly on the horizon is not hidden, and below the ground counts as on it", T, float,
                   double, long double) {
    CHECK_FALSE(behind_planet(T(6371), T(0), T(0)));
    CHECK_FALSE(behind_planet(T(6371), T(-100), T(0)));
    CHECK_FALSE(behind_planet(T(6371), T(-100), T(0.1L)));
    CHECK(behind_planet(T(6371), T(-100), T(-0.1L)));
    CHECK_FALSE(
        behind_planet(T(6371), T(1), std::numeric_limits<T>::quiet_NaN()));  // as the docstring promises
}

TEST_CASE_TEMPLATE("a term that is off equals its coefficients set to zero", T, float, double, long double) {
    Atmosphere<T> no_mie = earth<T>();
    no_mie.mie_scattering = no_mie.mie_absorption = vec3<T>(T(0));
    for (const T mu : {T(-0.2L), T(0), T(0.3L), T(1)}) {
        // Exact: adding 0 times a finite column changes nothing.
        check_same(transmittance_to_space<T, NoMie>(earth<T>(), T(10), mu),
                   transmittance_to_space<T>(no_mie, T(10), mu));
        if (!behind_planet(no_mie.ground_radius, T(10), mu)) {
            check_same(transmittance_to_space<T>(no_mie, T(10), mu),
                       transmittance_to_space<T, NoShadow>(no_mie, T(10), mu));
        }
    }
}

TEST_SUITE_END();
