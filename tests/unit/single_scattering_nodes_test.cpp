#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "table.hpp"
#include "views.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename Scene, typename T, typename Visibility = AlwaysLit>
Scattered<T> seen(const Atmosphere<T>& planet, const View<T>& view, const Visibility& visibility = {}) {
    return single_scattering<T, Scene>(planet, view.eye, view.direction, view.to_sun, view.distance,
                                       visibility);
}

// Largest errors of radiance and transmittance over the table's views, in a type and with a count of nodes.
template <typename T, typename Scene>
std::vector<double> table_errors(double& largest_transmittance_error) {
    std::vector<double> errors;
    double noon[3] = {0, 0, 0};
    largest_transmittance_error = 0;
    for (const Row& row : reference("single_scattering")) {
        const Scattered<T> got = seen<Scene>(table_air<T>(), table_view<T>(row));
        for (int k = 0; k < 3; ++k) {
            const double expected = static_cast<double>(row.expected("r" + std::to_string(k)));
            if (row.text("view") == "noon_zenith") {
                noon[k] = expected;
            }
            // Relative, but no smaller than to 1e-4 of the zenith at noon.
            const double scale = std::max(expected, 1e-4 * noon[k]);
            errors.push_back(std::fabs(static_cast<double>(got.radiance[k]) - expected) / scale);
            const double t = static_cast<double>(row.expected("t" + std::to_string(k)));
            largest_transmittance_error = std::max(largest_transmittance_error,
                                                   std::fabs(static_cast<double>(got.transmittance[k]) - t));
        }
    }
    return errors;
}

template <int Count>
void check_table(double largest, double typical) {
    double transmittance = 0;
    const auto print = [&transmittance](const char* type, const ErrorMetrics& errors) {
        std::printf(
            "%2d nodes, %s, table of views, each channel: max %.2e, p95 %.2e, median %.2e; transmittance "
            "%.1e\n",
            Count, type, errors.largest, errors.p95, errors.median, transmittance);
    };
    const ErrorMetrics in_double = error_metrics(table_errors<double, Nodes<Count>>(transmittance));
    print("double", in_double);
    CHECK(in_double.largest <= largest);
    CHECK(in_double.median <= typical);
    // The tent's density, straight in r^2, and Chapman's function to first order.
    CHECK(transmittance <= 1e-5);
    const ErrorMetrics in_float = error_metrics(table_errors<float, Nodes<Count>>(transmittance));
    print("float", in_float);
    CHECK(in_float.largest <= largest);  // the method errs by far more than a roundoff
    // Float rounds the direction from orbit: half a metre of height at the limb.
    CHECK(transmittance <= 2e-5);
}

}  // namespace

TEST_SUITE_BEGIN("single_scattering");

TEST_CASE_TEMPLATE("nodes: a kilometre of even, thin gas adds scattering times phase times length", T, float,
                   double, long double) {
    Atmosphere<T> planet = earth<T>();
    planet.rayleigh_scale_height = T(1e6);
    planet.rayleigh_scattering = vec3<T>(T(1e-20L), T(2e-20L), T(4e-20L));
    planet.mie_scattering = planet.mie_absorption = planet.ozone_absorption = vec3<T>(T(0));
    const View<T> view = {standing(T(100)), vec3<T>(T(0), T(0), T(1)), vec3<T>(T(1), T(0), T(0)), T(1000)};
    const Scattered<T> light = seen<DefaultScene>(planet, view);
    // Density exp(-h / 1000 km) from 100 to 1100 m: its mean is exp(-600 m / 1000 km) to 1e-7.
    const long double expected = 1e-20L * 1000 * std::exp(-6e-4L) * 0.0596831036594607508L;
    CHECK_WITHIN(compare_relative("single_scattering.radiance", {}, light.radiance.x, expected), 1e-5L);
    // The depth is 1e-17, which long double sees.
    CHECK(std::fabs(static_cast<long double>(light.transmittance.x) - 1) <= 1.1e-17L);
}

TEST_CASE("nodes: the more, the closer to the table of 7 digits") {
    // Each bound is the printed error with a tenth to spare; channels, not luminance, so larger than the
    // figures of docs/trade.md.
    check_table<4>(8.5e-2, 3.1e-3);
    check_table<6>(1.6e-2, 1.5e-4);
    check_table<8>(3.1e-3, 5.3e-6);
    check_table<10>(4.5e-3, 9.4e-6);
    check_table<16>(1.5e-3, 2.4e-6);
    check_table<24>(2.3e-4, 4.7e-7);
}

TEST_CASE_TEMPLATE("nodes: the march with many steps comes to the same light", T, double) {
    Random random(651);
    std::vector<double> errors;
    for (int i = 0; i < 60; ++i) {
        const View<T> view = random_view<T>(random);
        const Scattered<T> marched = single_scattering_marched<T>(earth<T>(), view.eye, view.direction,
                                                                  view.to_sun, view.distance, 8000);
        const Scattered<T> nodes = seen<Nodes<24>>(earth<T>(), view);
        for (int k = 0; k < 3; ++k) {
            errors.push_back(std::fabs(nodes.radiance[k] - marched.radiance[k]) /
                             std::max(marched.radiance[k], T(1e-6L)));
        }
    }
    // The march: 8000 steps, of first order at the shadow's edge.
    CHECK(error_metrics(errors).largest <= 5e-3);
    CHECK(error_metrics(errors).median <= 1e-5);
}

TEST_CASE_TEMPLATE("nodes: the ray's transmittance is that of transmittance()", T, float, double) {
    Random random(652);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const T altitude = T(random.log_uniform(1, 9e4));
        const T distance = random.below(2) == 0 ? no_surface<T>() : T(random.log_uniform(1, 1e6));
        const vec3<T> direction = slope<T>(random.uniform(0.0, 90));
        const Scattered<T> light =
            single_scattering<T>(earth<T>(), standing(altitude), direction, slope<T>(40), distance);
        const vec3<T> expected = transmittance<T>(earth<T>(), altitude, direction.z, distance);
        for (int k = 0; k < 3; ++k) {
            worst = std::max(worst, static_cast<double>(std::fabs(light.transmittance[k] - expected[k])));
        }
    }
    std::printf("transmittance of the ray against transmittance(), %s: %.1e\n", type_name<T>(), worst);
    // The tent's density is off by 2e-4 of its peak, its columns by 4e-5, of a depth of a half.
    CHECK(worst <= 2e-5);
}

TEST_CASE_TEMPLATE("nodes: the sky turned about the vertical is the same sky", T, float, double,
                   long double) {
    Random random(653);
    const auto turned = [](const vec3<T>& v) { return vec3<T>(-v.x, -v.y, v.z); };
    for (int i = 0; i < 500; ++i) {
        const View<T> view = random_view<T>(random);
        const View<T> other = {Viewpoint<T>{view.eye.altitude, turned(view.eye.up)}, turned(view.direction),
                               turned(view.to_sun), view.distance};
        // Exact: signs change in pairs.
        check_same(seen<DefaultScene>(earth<T>(), view), seen<DefaultScene>(earth<T>(), other));
    }
}

TEST_CASE_TEMPLATE("nodes: the sky does not depend on the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two, and so is its root
    Random random(654);
    const Atmosphere<T> scaled = rescaled(earth<T>(), k);
    for (int i = 0; i < 300; ++i) {
        const View<T> view = random_view<T>(random);
        const View<T> far = {Viewpoint<T>{k * view.eye.altitude, view.eye.up}, view.direction, view.to_sun,
                             k * view.distance};
        check_same(seen<DefaultScene>(scaled, far), seen<DefaultScene>(earth<T>(), view));
    }
}

TEST_CASE_TEMPLATE("nodes: a term that is off equals its coefficients set to zero", T, float, double,
                   long double) {
    Random random(655);
    Atmosphere<T> no_mie = earth<T>();
    no_mie.mie_scattering = no_mie.mie_absorption = vec3<T>(T(0));
    Atmosphere<T> no_ozone = earth<T>();
    no_ozone.ozone_absorption = vec3<T>(T(0));
    for (int i = 0; i < 300; ++i) {
        const View<T> view = random_view<T>(random);
        // Exact: 0 times a finite column is added, and nothing else hangs on it.
        check_same(seen<NoMie>(earth<T>(), view), seen<DefaultScene>(no_mie, view));
        check_same(seen<NoOzone>(earth<T>(), view), seen<DefaultScene>(no_ozone, view));
        check_same(seen<NoOzone>(earth<T>(), view), seen<Lorentzian>(no_ozone, view));
        const View<T> noon = {view.eye, view.eye.up, view.eye.up, view.distance};
        check_same(seen<DefaultScene>(earth<T>(), noon), seen<NoShadow>(earth<T>(), noon));
    }
}

TEST_CASE_TEMPLATE("nodes: at night the air is black, and as clear as by day", T, float, double,
                   long double) {
    const View<T> day = {standing(T(2)), slope<T>(30), slope<T>(60), no_surface<T>()};
    const View<T> night = {standing(T(2)), slope<T>(30), slope<T>(-60), no_surface<T>()};
    CHECK(seen<DefaultScene>(earth<T>(), night).radiance == vec3<T>(T(0)));  // exact: no piece is lit
    CHECK(seen<DefaultScene>(earth<T>(), night).transmittance ==
          seen<DefaultScene>(earth<T>(), day).transmittance);
}

TEST_CASE_TEMPLATE("nodes: in full shade there is no light, in half shade half of it", T, float, double,
                   long double) {
    Random random(656);
    for (int i = 0; i < 300; ++i) {
        const View<T> view = random_view<T>(random);
        const Scattered<T> lit = seen<DefaultScene>(earth<T>(), view);
        const Scattered<T> dark = seen<DefaultScene>(earth<T>(), view, Shaded{0.0});
        CHECK_UNARY(dark.radiance == vec3<T>(T(0)));  // exact: every term is times 0
        CHECK_UNARY(dark.transmittance == lit.transmittance);
        const Scattered<T> half = seen<DefaultScene>(earth<T>(), view, Shaded{0.5});
        CHECK_UNARY(half.radiance == lit.radiance * T(0.5));  // exact: a power of two
    }
}

TEST_CASE_TEMPLATE("nodes: the hook is asked at the nodes, relative to the eye, inside the ray's air", T,
                   float, double, long double) {
    std::vector<vec3<T>> positions;
    const vec3<T> down = vec3<T>(T(0), T(0), T(-1));
    const View<T> view = {standing(T(300e3L)), down, slope<T>(50), no_surface<T>()};
    seen<DefaultScene>(earth<T>(), view, Recorder<T>{&positions});
    REQUIRE(positions.size() == std::size_t(DefaultScene::nodes));
    for (const vec3<T>& p : positions) {
        CHECK(p.x == T(0));  // exact: the direction's components times a number
        CHECK(p.y == T(0));
        CHECK(p.z < T(-200e3L));
        CHECK(p.z > T(-300e3L));
    }
    // Through the limb there are two pieces, down and up.
    positions.clear();
    const T sine = (earth<T>().ground_radius + T(20e3L)) / (earth<T>().ground_radius + T(300e3L));
    const View<T> limb = {standing(T(300e3L)), vec3<T>(sine, T(0), -std::sqrt((T(1) - sine) * (T(1) + sine))),
                          slope<T>(50), no_surface<T>()};
    seen<NoOzone>(earth<T>(), limb, Recorder<T>{&positions});
    CHECK(positions.size() == std::size_t(2 * DefaultScene::nodes));
}

TEST_CASE_TEMPLATE("nodes: no way and no air: radiance 0, transmittance 1", T, float, double, long double) {
    const auto check_clear = [](const Scattered<T>& light) {
        CHECK(light.radiance == vec3<T>(T(0)));  // as the docstring promises
        CHECK(light.transmittance == vec3<T>(T(1)));
    };
    check_clear(seen<DefaultScene>(earth<T>(), View<T>{standing(T(2)), slope<T>(30), slope<T>(40), T(0)}));
    check_clear(seen<DefaultScene>(
        earth<T>(), View<T>{standing(T(300e3L)), slope<T>(10), slope<T>(40), no_surface<T>()}));
    check_clear(seen<DefaultScene>(earth<T>(),
                                   View<T>{standing(T(0)), slope<T>(-30), slope<T>(40), no_surface<T>()}));
    const Atmosphere<T> vacuum = airless(earth<T>());
    check_clear(
        seen<DefaultScene>(vacuum, View<T>{standing(T(2)), slope<T>(30), slope<T>(40), no_surface<T>()}));
}

TEST_CASE_TEMPLATE("nodes: an eye below the ground sees what an eye standing on it sees", T, float, double,
                   long double) {
    for (const T depth : {T(1e-3L), T(100), T(1e5L), earth<T>().ground_radius}) {
        for (const double elevation : {90.0, 20.0, 1.0}) {
            for (const vec3<T>& sun : {slope<T>(50, 20), slope<T>(2, 100), slope<T>(-4)}) {
                const View<T> below = {standing(-depth), slope<T>(elevation), sun, no_surface<T>()};
                const View<T> on = {standing(T(0)), slope<T>(elevation), sun, no_surface<T>()};
                // Exact: the same altitude after clamping.
                check_same(seen<DefaultScene>(earth<T>(), below), seen<DefaultScene>(earth<T>(), on));
            }
        }
    }
}

TEST_CASE("nodes: the sky changes smoothly as the sun sets, as the eye climbs and past the horizon") {
    // Neighbouring views differ by a thousandth of the whole way; no step of the light may be larger than ten
    // times the mean change of a thousandth of all the light there is, or than the error of eight nodes.
    const auto largest_jump = [](auto view_at) {
        double jump = 0;
        double before = -1;
        double highest = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double now = luminance(seen<DefaultScene>(earth<double>(), view_at(i / 1000.0)).radiance);
            highest = std::max(highest, now);
            jump = before < 0 ? 0.0 : std::max(jump, std::fabs(now - before));
            before = now;
        }
        return jump / highest;
    };
    const double sunset = largest_jump([](double x) {
        return View<double>{standing(2.0), slope<double>(10, 20), slope<double>(5 - 11 * x),
                            no_surface<double>()};
    });
    const double climb = largest_jump([](double x) {
        return View<double>{standing(1e6 * x * x), slope<double>(-60, 20), slope<double>(20),
                            no_surface<double>()};
    });
    const double twilight_climb = largest_jump([](double x) {
        return View<double>{standing(2e5 * x), slope<double>(5, 20), slope<double>(-4), no_surface<double>()};
    });
    std::printf("largest jump in a thousandth: sunset %.1e, climb %.1e, climb at twilight %.1e of the peak\n",
                sunset, climb, twilight_climb);
    CHECK(sunset <= 1e-2);
    CHECK(climb <= 1e-2);
    CHECK(twilight_climb <= 2e-2);  // the horizon's glow comes up within 10 km
}

TEST_SUITE_END();
