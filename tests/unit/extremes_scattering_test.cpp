// Single scattering at and between the ends of every parameter.

#include <doctest/doctest.h>

#include "samplers.hpp"
#include "scattering_promises.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T, typename Integrator>
void any_view(const char* name, const Integrator& integrator, int count) {
    Random random(411);
    Verdict all;
    for (int i = 0; i < count; ++i) {
        check_any_view<T>(all, random, integrator);
    }
    all.print((std::string(name) + ", " + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

template <typename T, typename Integrator>
void corner_views(const char* name, const Integrator& integrator) {
    Verdict all;
    Atmosphere<T> thick = earth<T>();
    thick.rayleigh_scattering *= T(1e4L);
    Atmosphere<T> pebble = earth<T>();
    pebble.ground_radius = T(100);
    Atmosphere<T> giant = earth<T>();
    giant.ground_radius = T(7e7);
    giant.rayleigh_scale_height = T(0.1L);
    Atmosphere<T> bare = earth<T>();
    bare.top_altitude = T(0);
    Atmosphere<T> peaked = earth<T>();
    peaked.mie_g = T(1) - T(1e-7L);
    for (const Atmosphere<T>& air :
         {earth<T>(), mars<T>(), leenman_earth<T>(), thick, pebble, giant, bare, peaked}) {
        const vec3<T> up(T(0), T(0), T(1));
        for (const T altitude : {-air.ground_radius, T(-1), T(0), T(1e-6L), T(2), air.top_altitude,
                                 2 * air.top_altitude, T(1e9L), T(1e12L)}) {
            // Down to the horizon, exactly.
            const T sine = air.ground_radius / std::fmax(air.ground_radius + altitude, air.ground_radius);
            const vec3<T> tangent(sine, T(0), -std::sqrt((T(1) - sine) * (T(1) + sine)));
            for (const vec3<T>& direction :
                 {up, -up, vec3<T>(T(1), T(0), T(0)), tangent, vec3<T>(T(0.6L), T(0), T(-0.8L))}) {
                for (const vec3<T>& sun : {up, -up, vec3<T>(T(1), T(0), T(0)), vec3<T>(T(-1), T(0), T(0)),
                                           direction, -direction}) {
                    for (const T distance : {T(0), T(1e-6L), T(100), no_surface<T>()}) {
                        check_view(all, integrator, air, Viewpoint<T>{altitude, up}, direction, sun, distance,
                                   T(0.5L));
                    }
                }
            }
        }
    }
    all.print((std::string(name) + " in the corners, " + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

// Sky and sun on level ground under flat air, over the sunlight that falls on the air: midpoints of 12
// cosines and 12 azimuths.
template <typename Integrator>
double light_on_ground(const Integrator& integrator, const Atmosphere<double>& air, double mu_s) {
    const Viewpoint<double> eye = {0.0, vec3<double>(0.0, 0.0, 1.0)};
    const vec3<double> to_sun(std::sqrt((1 - mu_s) * (1 + mu_s)), 0.0, mu_s);
    const int count = 12;
    double sky = 0;
    for (int i = 0; i < count; ++i) {
        const double mu = (i + 0.5) / count;
        for (int j = 0; j < count; ++j) {
            const double azimuth = pi<double> * (j + 0.5) / count;
            const double sine = std::sqrt((1 - mu) * (1 + mu));
            const vec3<double> direction(sine * std::cos(azimuth), sine * std::sin(azimuth), mu);
            sky += integrator
                       .template view<double, Bare>(air, eye, direction, to_sun, no_surface<double>(),
                                                    AlwaysLit{})
                       .radiance.x *
                   mu * 2 * pi<double> / (count * count);
        }
    }
    return (sky + mu_s * transmittance_to_space<double, Bare>(air, 0.0, mu_s).x) / mu_s;
}

}  // namespace

TEST_SUITE_BEGIN("extremes_scattering");

TEST_CASE_TEMPLATE("the march keeps its promises for any view of any planet", T, float, double, long double) {
    for (const int steps : {1, 2, 6}) {
        any_view<T>(("the march by " + std::to_string(steps)).c_str(), Marched{steps}, 12000);
    }
}

TEST_CASE_TEMPLATE("the march keeps its promises where eye, view and sun stand in the corners", T, float,
                   double, long double) {
    corner_views<T>("the march", Marched{4});
}

TEST_CASE_TEMPLATE("nodes keep their promises for any view of any planet", T, float, double, long double) {
    any_view<T>("4 nodes", ByNodes<4>{}, 12000);
    any_view<T>("5 nodes", ByNodes<5>{}, 6000);
    any_view<T>("6 nodes", ByNodes<6>{}, 6000);
    any_view<T>("8 nodes", ByNodes<8>{}, 24000);
    any_view<T>("10 nodes", ByNodes<10>{}, 6000);
    any_view<T>("12 nodes", ByNodes<12>{}, 6000);
    any_view<T>("16 nodes", ByNodes<16>{}, 6000);
    any_view<T>("24 nodes", ByNodes<24>{}, 6000);
}

TEST_CASE_TEMPLATE("nodes keep their promises where eye, view and sun stand in the corners", T, float, double,
                   long double) {
    corner_views<T>("8 nodes", ByNodes<8>{});
}

TEST_CASE_TEMPLATE("shadows keep those promises", T, float, double, long double) {
    any_view<T>("a shadow of 1 look", ByShafts{1, 1}, 12000);
    any_view<T>("a shadow of 3 x 2 looks", ByShafts{3, 2}, 12000);
    any_view<T>("a shadow of 8 x 4 looks", ByShafts{8, 4}, 6000);
    corner_views<T>("a shadow of 4 x 2 looks", ByShafts{4, 2});
}

TEST_CASE("sky and sun together light the ground with no more than the sun's light") {
    Atmosphere<double> flat = earth<double>();
    flat.ground_radius = 7e7;
    flat.rayleigh_scale_height = 100;
    flat.top_altitude = 2000;
    for (const double depth : {1e-3, 0.1, 1.0, 3.0, 10.0, 1000.0}) {
        flat.rayleigh_scattering = vec3<double>(depth / flat.rayleigh_scale_height);
        for (const double mu_s : {1.0, 0.5, 0.1}) {
            CAPTURE(depth);
            CAPTURE(mu_s);
            const double marched = light_on_ground(Marched{400}, flat, mu_s);
            CHECK(marched >= 0.0);  // 0 below 1000 depths: exp(-1000) is none in double
            CHECK(marched < 1.0);
            const double by_nodes = light_on_ground(ByNodes<8>{}, flat, mu_s);
            CHECK(by_nodes >= 0.0);
            CHECK(by_nodes < 1.0);
        }
    }
}

TEST_SUITE_END();
