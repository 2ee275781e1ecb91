#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/multiple_scattering.hpp>

#include "angles.hpp"
#include "error_metrics.hpp"
#include "extremes.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "views.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// The same from all sides and everywhere.
struct Everywhere {
    double radiance;
    template <typename T>
    DiffuseLight<T> operator()(T, T) const {
        return even_light(vec3<T>(T(radiance)));
    }
};

// Fades upwards and towards the night, as that of the blue sky does.
struct Fading {
    template <typename T>
    DiffuseLight<T> operator()(T altitude, T mu_s) const {
        return even_light(vec3<T>(std::exp(-altitude / T(2e4)) * std::exp(T(8) * std::fmin(mu_s, T(0)))));
    }
};

template <typename T>
vec3<T> direction_at(double mu) {
    return vec3<T>(T(std::sqrt((1 - mu) * (1 + mu))), T(0), T(mu));
}

}  // namespace

TEST_SUITE_BEGIN("multiple_scattering");

TEST_CASE_TEMPLATE(
    "in even light, air that absorbs nothing shows it as far as it hides what is behind: L (1 - T)", T, float,
    double) {
    Atmosphere<T> air = earth<T>();
    air.mie_absorption = air.ozone_absorption = vec3<T>(T(0));
    const vec3<T> to_sun = direction_at<T>(0.3);
    double worst = 0;
    for (const double altitude : {0.0, 2.0, 5e3, 40e3}) {
        for (const double mu : {1.0, 0.5, 0.1, 0.02, 0.0, -0.02, -0.5, -1.0}) {
            const Viewpoint<T> eye{T(altitude), vec3<T>(T(0), T(0), T(1))};
            const vec3<T> direction = direction_at<T>(mu);
            const vec3<T> got =
                diffuse_scattering<T, Nodes<12>>(air, eye, direction, to_sun, no_surface<T>(), Everywhere{2});
            const Scattered<T> once =
                single_scattering<T, Nodes<12>>(air, eye, direction, to_sun, no_surface<T>());
            for (int c = 0; c < 3; ++c) {
                const double expected = 2 * (1 - static_cast<double>(once.transmittance[c]));
                worst = std::max(worst, std::fabs(static_cast<double>(got[c]) - expected));
            }
        }
    }
    MESSAGE("worst error of the radiance " << worst);
    CHECK(worst <= 1e-5);  // loss_ratio makes it exact; both depths are differences of columns in float
}

TEST_CASE_TEMPLATE("in even light so does fog, however thick and however thin its layer", T, float, double) {
    for (const double fog : {1e-4, 0.04, 0.5, 10.0, 1e4}) {
        Atmosphere<T> air = earth<T>();
        air.mie_absorption = air.ozone_absorption = vec3<T>(T(0));
        air.mie_scale_height = T(100);
        air.mie_scattering = vec3<T>(T(fog));
        for (const double altitude : {2.0, 5e3, 20e3}) {
            for (const double mu : {1.0, 0.5, 0.1, 0.0, -0.05, -0.1, -0.2, -0.7, -1.0}) {
                const Viewpoint<T> eye{T(altitude), vec3<T>(T(0), T(0), T(1))};
                const vec3<T> direction = direction_at<T>(mu);
                const vec3<T> got = diffuse_scattering<T>(air, eye, direction, direction_at<T>(0.3),
                                                          no_surface<T>(), Everywhere{1});
                const Scattered<T> once =
                    single_scattering<T>(air, eye, direction, direction_at<T>(0.3), no_surface<T>());
                CAPTURE(fog);
                CAPTURE(altitude);
                CAPTURE(mu);
                for (int c = 0; c < 3; ++c) {
                    // loss_ratio makes it exact; differences of columns of depth 2000 keep 1e-4 of
                    // themselves.
                    CHECK(std::fabs(static_cast<double>(got[c]) -
                                    (1 - static_cast<double>(once.transmittance[c]))) <= 1e-3);
                }
            }
        }
    }
}

TEST_CASE("8 nodes find what 24 find, ozone's edges or not") {
    Random random(31);
    const Atmosphere<double> air = earth<double>();
    std::vector<double> errors;
    for (int i = 0; i < 4000; ++i) {
        const Viewpoint<double> eye = standing(random.log_uniform(1, 6e4));
        const double elevation = random.uniform(-90, 90);
        const double azimuth = random.uniform(0, 180);
        const vec3<double> direction = slope<double>(elevation, azimuth);
        const vec3<double> to_sun = slope<double>(random.uniform(-10, 90));
        const double few =
            diffuse_scattering<double>(air, eye, direction, to_sun, no_surface<double>(), Fading{}).y;
        const double many =
            diffuse_scattering<double, Nodes<24>>(air, eye, direction, to_sun, no_surface<double>(), Fading{})
                .y;
        errors.push_back(std::fabs(few / many - 1));
    }
    const ErrorMetrics error = error_metrics(errors);
    MESSAGE("median " << error.median << ", p95 " << error.p95 << ", max " << error.largest);
    CHECK(error.p95 < 6e-5);      // measured: 4.5e-5
    CHECK(error.largest < 1e-3);  // measured: 6.5e-4
}

TEST_CASE_TEMPLATE("any air, ray and sun: light is finite, never negative and never made", T, float, double) {
    Random random(412);
    for (int i = 0; i < 20000; ++i) {
        const Atmosphere<T> air = any_atmosphere<T>(random);
        const Viewpoint<T> eye = any_viewpoint(random, air);
        const vec3<T> direction = any_direction(random, air, eye);
        const vec3<T> to_sun = any_sun(random, air, eye, direction);
        const vec3<T> got =
            diffuse_scattering<T>(air, eye, direction, to_sun, any_distance<T>(random), Everywhere{1});
        CAPTURE(i);
        for (int c = 0; c < 3; ++c) {
            CHECK(got[c] >= T(0));        // false for NaN
            CHECK(got[c] <= T(1.0001L));  // 1 and the roundoffs of loss_ratio
        }
    }
}

TEST_CASE("marched and by nodes it is the same light") {
    const Atmosphere<double> air = earth<double>();
    for (const double mu : {1.0, 0.3, 0.05, -0.3}) {
        const Viewpoint<double> eye{1000, vec3<double>(0, 0, 1)};
        const vec3<double> direction = direction_at<double>(mu);
        const vec3<double> to_sun = direction_at<double>(-0.1);
        const vec3<double> nodes = diffuse_scattering<double, Nodes<24>>(air, eye, direction, to_sun,
                                                                         no_surface<double>(), Everywhere{1});
        const vec3<double> marched = diffuse_scattering_marched<double>(
            air, eye, direction, to_sun, no_surface<double>(), 4000, Everywhere{1});
        for (int c = 0; c < 3; ++c) {
            CHECK(nodes[c] == doctest::Approx(marched[c]).epsilon(1e-3));  // 4000 steps along the horizon
        }
    }
}

TEST_CASE_TEMPLATE("all scattering is what was scattered once and what was scattered again", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const Viewpoint<T> eye{T(100), vec3<T>(T(0), T(0), T(1))};
    const vec3<T> direction = direction_at<T>(0.2);
    const vec3<T> to_sun = direction_at<T>(0.5);
    const Scattered<T> all =
        all_scattering<T>(air, eye, direction, to_sun, no_surface<T>(), Everywhere{0.125}, Shaded{0.5});
    const Scattered<T> once = single_scattering<T>(air, eye, direction, to_sun, no_surface<T>(), Shaded{0.5});
    // Exact: the same two calls.
    CHECK(all.radiance == once.radiance + diffuse_scattering<T>(air, eye, direction, to_sun, no_surface<T>(),
                                                                Everywhere{0.125}));
    CHECK(all.transmittance == once.transmittance);
    CHECK(diffuse_scattering<T>(air, eye, direction, to_sun, no_surface<T>()) == vec3<T>(T(0)));
}

TEST_CASE_TEMPLATE("the planet's shadow does not end light from all sides", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const Viewpoint<T> eye{T(2), vec3<T>(T(0), T(0), T(1))};
    const vec3<T> night = direction_at<T>(-0.9);
    const vec3<T> up(T(0), T(0), T(1));
    CHECK(single_scattering<T>(air, eye, up, night, no_surface<T>()).radiance.y == T(0));
    CHECK(diffuse_scattering<T>(air, eye, up, night, no_surface<T>(), Everywhere{1}).y > T(0.05L));
}

TEST_CASE("light scales with its source and not with the unit of length") {
    const Atmosphere<double> metres = earth<double>();
    const Atmosphere<double> units = rescaled(metres, 1024.0);
    for (const double mu : {0.9, 0.01, -0.4}) {
        const vec3<double> up(0, 0, 1);
        const vec3<double> direction = direction_at<double>(mu);
        const vec3<double> to_sun = direction_at<double>(0.1);
        const vec3<double> a = diffuse_scattering<double>(metres, {1000, up}, direction, to_sun,
                                                          no_surface<double>(), Everywhere{1});
        const vec3<double> b = diffuse_scattering<double>(units, {1024000, up}, direction, to_sun,
                                                          no_surface<double>(), Everywhere{1});
        const vec3<double> c = diffuse_scattering<double>(metres, {1000, up}, direction, to_sun,
                                                          no_surface<double>(), Everywhere{8});
        for (int k = 0; k < 3; ++k) {
            CHECK(b[k] == doctest::Approx(a[k]).epsilon(1e-13));  // roots of odd powers of 1024 round
            CHECK(c[k] == 8 * a[k]);                              // exact: a power of two
        }
    }
}

TEST_CASE_TEMPLATE("without air, without substance and without way nothing is added", T, float, double) {
    Atmosphere<T> air = earth<T>();
    const vec3<T> up(T(0), T(0), T(1));
    const vec3<T> none(T(0));
    CHECK(diffuse_scattering<T>(air, {T(2), up}, up, up, T(0), Everywhere{1}) == none);
    CHECK(diffuse_scattering<T>(air, {T(200e3), up}, up, up, no_surface<T>(), Everywhere{1}) == none);
    CHECK(diffuse_scattering_marched<T>(air, {T(2), up}, up, up, no_surface<T>(), 0, Everywhere{1}) == none);
    air.rayleigh_scattering = air.mie_scattering = none;
    CHECK(diffuse_scattering<T>(air, {T(2), up}, up, up, no_surface<T>(), Everywhere{1}) == none);
}

TEST_SUITE_END();
