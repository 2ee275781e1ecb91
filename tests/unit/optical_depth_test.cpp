#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/constants.hpp>
#include <airlight/optical_depth.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T>
void check_same(const vec3<T>& a, const vec3<T>& b) {
    for (int i = 0; i < 3; ++i) {
        CHECK_EQUAL(compare_ulp("optical_depth", {{"channel", T(i)}}, a[i], b[i]));
    }
}

}  // namespace

TEST_SUITE_BEGIN("optical_depth");

TEST_CASE_TEMPLATE("each substance takes its column times its extinction", T, float, double, long double) {
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scattering = vec3<T>(T(1), T(2), T(3));
    planet.mie_scattering = vec3<T>(T(4), T(5), T(6));
    planet.mie_absorption = vec3<T>(T(0.5), T(0.25), T(0.125));
    planet.ozone_absorption = vec3<T>(T(7), T(8), T(9));
    // Exact: small integers and halves. 10 1 + 100 4.5 + 1000 7 and so on.
    check_same(column_optical_depth<T>(planet, Column<T>{T(10), T(100), T(1000)}),
               vec3<T>(T(7460), T(8545), T(9642.5)));
}

TEST_CASE_TEMPLATE("a ray of 10 km through even air of 0.1 per km has optical depth 1 of each kind", T, float,
                   double, long double) {
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scale_height = T(1e30L);
    planet.mie_scale_height = T(1e30L);
    planet.ozone_half_width = T(1e30L);
    planet.rayleigh_scattering = vec3<T>(T(1e-4L), T(0), T(0));
    planet.mie_scattering = vec3<T>(T(0), T(1e-4L), T(0));
    planet.mie_absorption = vec3<T>(T(0));
    planet.ozone_absorption = vec3<T>(T(0), T(0), T(1e-4L));
    const vec3<T> depth = optical_depth<T>(planet, T(1000), T(1), T(10000));
    for (int i = 0; i < 3; ++i) {
        CHECK_WITHIN(compare_ulp("optical_depth", {{"channel", T(i)}}, depth[i], 1.0L),
                     4.0L);  // the docstring's bound
    }
}

TEST_CASE_TEMPLATE(
    "optical depth is the integral and transmittance its exponential, so depths add along a ray", T, float,
    double, long double) {
    // Our choice of words where a source calls transmittance "optical depth" and the reverse. In even air the
    // depth of a way is the sum of the depths of its parts; a transmittance would be their product.
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scale_height = T(1e30L);
    planet.mie_scale_height = T(1e30L);
    planet.ozone_half_width = T(1e30L);
    const vec3<T> first = optical_depth<T>(planet, T(1000), T(1), T(2000));
    const vec3<T> second = optical_depth<T>(planet, T(3000), T(1), T(6000));
    const vec3<T> whole = optical_depth<T>(planet, T(1000), T(1), T(8000));
    for (int i = 0; i < 3; ++i) {
        CHECK_WITHIN(compare_ulp("optical_depth", {}, first[i] + second[i], whole[i]), 8.0L);  // two of 4 ulp
        CHECK(whole[i] > T(0));
    }
}

TEST_CASE_TEMPLATE("optical depth grows with distance and with every coefficient", T, float, double,
                   long double) {
    Random random(101);
    for (int i = 0; i < 500; ++i) {
        Atmosphere<T> planet = earth<T>();
        const T h = T(random.log_uniform(1, 5e4));
        const T mu = T(random.uniform(0, 1));
        // Even air: growth must hold for every distance.
        planet.rayleigh_scale_height = T(1e30L);
        planet.mie_scale_height = T(1e30L);
        const T d = T(random.log_uniform(1, 1e4));
        const vec3<T> near = optical_depth<T>(planet, h, mu, d);
        const vec3<T> far = optical_depth<T>(planet, h, mu, 2 * d);
        planet.mie_absorption *= T(2);
        const vec3<T> hazy = optical_depth<T>(planet, h, mu, d);
        for (int k = 0; k < 3; ++k) {
            CHECK_UNARY(near[k] >= T(0));
            CHECK_UNARY(far[k] >= near[k]);
            CHECK_UNARY(hazy[k] >= near[k]);
        }
    }
}

TEST_CASE_TEMPLATE("the aerosol's coefficients are the user's constants and act linearly", T, float, double,
                   long double) {
    // Our reading of a published aerosol formula without a wavelength: it is no coefficient per length, so
    // there is no function for it; what the user sets is what extinguishes.
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scattering = vec3<T>(T(0));
    planet.ozone_absorption = vec3<T>(T(0));
    const vec3<T> once = optical_depth<T>(planet, T(0), T(0.5), no_surface<T>());
    planet.mie_scattering *= T(4);
    planet.mie_absorption *= T(4);
    check_same(optical_depth<T>(planet, T(0), T(0.5), no_surface<T>()),
               once * T(4));  // exact: a power of two
}

TEST_CASE_TEMPLATE("optical depths do not depend on the unit of length", T, float, double, long double) {
    const Atmosphere<T> planet = earth<T>();
    const T k = 1024;  // exact: a power of two
    const Atmosphere<T> scaled = rescaled(planet, k);
    Random random(102);
    for (int i = 0; i < 300; ++i) {
        const T h = T(random.log_uniform(0.1, 1e6));
        const T mu = T(random.uniform(-1, 1));
        const T d = random.below(2) == 0 ? no_surface<T>() : T(random.log_uniform(1, 1e6));
        check_same(optical_depth<T>(scaled, k * h, mu, k * d), optical_depth<T>(planet, h, mu, d));
        check_same(optical_depth<T, Lorentzian>(scaled, k * h, mu, k * d),
                   optical_depth<T, Lorentzian>(planet, h, mu, d));
    }
}

TEST_CASE_TEMPLATE("a term that is off equals its coefficients set to zero", T, float, double, long double) {
    Atmosphere<T> no_mie = earth<T>();
    no_mie.mie_scattering = no_mie.mie_absorption = vec3<T>(T(0));
    Atmosphere<T> no_ozone = earth<T>();
    no_ozone.ozone_absorption = vec3<T>(T(0));
    Random random(103);
    for (int i = 0; i < 200; ++i) {
        const T h = T(random.log_uniform(0.1, 1e5));
        const T mu = T(random.uniform(-1, 1));
        // Exact: adding 0 times a finite column changes nothing.
        check_same(optical_depth<T, NoMie>(earth<T>(), h, mu, T(1e5L)),
                   optical_depth<T>(no_mie, h, mu, T(1e5L)));
        check_same(optical_depth<T, NoOzone>(earth<T>(), h, mu, T(1e5L)),
                   optical_depth<T>(no_ozone, h, mu, T(1e5L)));
        check_same(optical_depth<T, NoOzone>(earth<T>(), h, mu, T(1e5L)),
                   optical_depth<T, Lorentzian>(no_ozone, h, mu, T(1e5L)));
    }
}

TEST_CASE_TEMPLATE("a view ray's steps are its own: what lies on a ray takes none", T, float, double,
                   long double) {
    // Our reading of a source that passes one step count for two loops: the inner loop is gone.
    const Column<T> air = column<T>(earth<T>(), T(100), T(0.3L), T(50000));
    check_same(optical_depth<T>(earth<T>(), T(100), T(0.3L), T(50000)),
               column_optical_depth<T>(earth<T>(), air));  // exact: the same operations
}

TEST_CASE_TEMPLATE("no way, no depth", T, float, double, long double) {
    check_same(optical_depth<T>(earth<T>(), T(100), T(0.3L), T(0)), vec3<T>(T(0)));
    check_same(optical_depth<T>(earth<T>(), T(200e3L), T(1), no_surface<T>()), vec3<T>(T(0)));
}

TEST_SUITE_END();
