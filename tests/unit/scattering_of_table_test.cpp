#include <cmath>
#include <cstdio>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/scattering_of_table.hpp>
#include <airlight/scattering_orders.hpp>

#include "error_metrics.hpp"
#include "extremes.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "views.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

using Scene = Nodes<24>;

/// A table without texels: computes what it is asked for.
template <typename T>
struct Computed {
    const Atmosphere<T>& planet;
    bool of_molecules;
    vec3<T> operator()(T altitude, T mu, T mu_s, T nu, bool reaches_ground) const {
        const InScatter<T> light = single_inscatter<T, Scene>(planet, altitude, mu, mu_s, nu, reaches_ground);
        return of_molecules ? light.rayleigh : light.mie;
    }
};

/// The light before a surface by such a table, seen from space with the sun 40 degrees up.
template <typename T>
Scattered<T> to_surface(double altitude, const vec3<double>& direction, double distance) {
    const Atmosphere<T> planet = earth<T>();
    return scattering_of_table<T, Scene>(planet, standing(T(altitude)), vec3<T>(direction), slope<T>(40),
                                         T(distance), Computed<T>{planet, true}, Computed<T>{planet, false});
}

/// A table of noise.
struct Noise {
    mutable Random random{3};
    template <typename T>
    vec3<T> operator()(T, T, T, T, bool) const {
        return vec3<T>(T(random.unit()), T(random.unit()), T(random.log_uniform(1e-30, 1e30)));
    }
};

}  // namespace

TEST_SUITE_BEGIN("scattering_of_table");

TEST_CASE_TEMPLATE("without tables there is no light, and the transmittance of the ray", T, float, double) {
    const Atmosphere<T> planet = earth<T>();
    const Scattered<T> seen =
        scattering_of_table<T>(planet, standing(T(100)), slope<T>(30), slope<T>(60), T(20e3));
    CHECK(seen.radiance == vec3<T>(T(0)));
    const vec3<T> expected = transmittance<T>(planet, T(100), slope<T>(30).z, T(20e3));
    for (int i = 0; i < 3; ++i) {
        CHECK_WITHIN(compare_relative("scattering_of_table.transmittance", {}, seen.transmittance[i],
                                      static_cast<long double>(expected[i])),
                     1e-6L);  // modelling: the cosine makes the way through the sine and back
    }
}

TEST_CASE("a table without error gives the light of single_scattering, to the sky and to surfaces") {
    const Atmosphere<double> planet = earth<double>();
    Random random(17);
    std::vector<double> to_sky;
    std::vector<double> to_surface;
    for (int i = 0; i < 3000; ++i) {
        const double altitude = random.log_uniform(1, 1e6);
        const vec3<double> direction = slope<double>(random.uniform(-90, 60), random.uniform(0, 180));
        const vec3<double> to_sun = slope<double>(random.uniform(-4, 90));
        const bool endless = i % 2 == 0;
        const double distance = endless ? no_surface<double>() : random.log_uniform(1e3, 3e5);
        const Scattered<double> expected =
            single_scattering<double, Scene>(planet, standing(altitude), direction, to_sun, distance);
        const Scattered<double> got = scattering_of_table<double, Scene>(
            planet, standing(altitude), direction, to_sun, distance, Computed<double>{planet, true},
            Computed<double>{planet, false});
        if (expected.radiance.y > 1e-5) {
            (endless ? to_sky : to_surface).push_back(std::fabs(got.radiance.y / expected.radiance.y - 1));
        }
        for (int c = 0; c < 3; ++c) {
            // Two routes to the same closed form, 1e-4 of a column apart at worst.
            CHECK(std::fabs(got.transmittance[c] - expected.transmittance[c]) < 1e-4);
        }
    }
    const ErrorMetrics sky = error_metrics(to_sky);
    const ErrorMetrics surface = error_metrics(to_surface);
    std::printf(
        "accuracy scattering_of_table<double>, computed: sky p95 %.2g max %.2g (%zu), surfaces p95 %.2g max "
        "%.2g (%zu)\n",
        sky.p95, sky.largest, to_sky.size(), surface.p95, surface.largest, to_surface.size());
    CHECK(to_sky.size() > 1000);
    CHECK(to_surface.size() > 700);
    CHECK(sky.p95 < 5e-4);      // modelling: as order 1 against single_scattering
    CHECK(surface.p95 < 5e-3);  // a difference: what is left of the two rays' errors
}

TEST_CASE_TEMPLATE(
    "whatever stands in the table: the light to a surface is not negative, nor more than the sky's", T, float,
    double) {
    const Atmosphere<T> planet = earth<T>();
    Random random(23);
    for (int i = 0; i < 20000; ++i) {
        const View<T> view = random_view<T>(random);
        const Scattered<T> seen = scattering_of_table<T, DefaultScene>(
            planet, view.eye, view.direction, view.to_sun, view.distance, Noise{}, Noise{}, Noise{});
        for (int c = 0; c < 3; ++c) {
            CHECK(std::isfinite(seen.radiance[c]));
            CHECK(seen.radiance[c] >= T(0));
            CHECK(seen.transmittance[c] >= T(0));
            CHECK(seen.transmittance[c] <= T(1));
        }
    }
}

TEST_CASE(
    "in float a surface far below an eye in space ends its ray, whatever the sum of distances rounds to") {
    // 32754.59375 m + 92688.2109375 m is 125442.8046875 m, and a rounding less in float.
    const vec3<double> down(0, 0, -1);
    const Scattered<float> seen = to_surface<float>(132754.59375, down, 125442.8046875);
    const Scattered<double> expected = to_surface<double>(132754.59375, down, 125442.8046875);
    const Scattered<double> whole = to_surface<double>(132754.59375, down, no_surface<double>());
    CHECK(expected.radiance.y < 0.7 * whole.radiance.y);
    CHECK(static_cast<double>(seen.radiance.y) == doctest::Approx(expected.radiance.y).epsilon(1e-4));

    Random random(29);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        // Numbers that float holds, so that both see the same ray.
        const double altitude = static_cast<double>(static_cast<float>(random.uniform(110e3, 400e3)));
        const vec3<double> direction(vec3<float>(slope<double>(random.uniform(-90, -60))));
        const double share = random.uniform(0.1, 0.9);
        const AirRay<double> ray =
            air_ray(earth<double>(), standing(altitude), direction, no_surface<double>());
        const double distance = static_cast<double>(static_cast<float>(ray.begin + share * ray.extent));
        const Scattered<float> narrow = to_surface<float>(altitude, direction, distance);
        const Scattered<double> exact = to_surface<double>(altitude, direction, distance);
        const Scattered<double> all = to_surface<double>(altitude, direction, no_surface<double>());
        worst = std::fmax(
            worst, std::fabs(static_cast<double>(narrow.radiance.y) - exact.radiance.y) / all.radiance.y);
    }
    std::printf("accuracy scattering_of_table<float>, surfaces from space: worst %.2g of the whole ray\n",
                worst);
    CHECK(worst < 2e-5);  // roundoffs of two rays' light and of where the surface is (measured: 5.5e-6)
}

TEST_CASE_TEMPLATE("rays past the air are empty", T, float, double) {
    const Atmosphere<T> planet = earth<T>();
    const Scattered<T> seen = scattering_of_table<T, DefaultScene>(
        planet, standing(T(4e5L)), slope<T>(10), slope<T>(60), no_surface<T>(), Noise{}, Noise{}, Noise{});
    CHECK(seen.radiance == vec3<T>(T(0)));
    CHECK(seen.transmittance == vec3<T>(T(1)));
}

TEST_SUITE_END();
