// Tables of scattered light, made order by order, against the path tracer and against what must hold of any.
#include <cmath>
#include <cstdio>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/tables/bruneton.hpp>
#include <airlight/tables/inscatter.hpp>

#include "error_metrics.hpp"
#include "path_traced.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "views.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

template <typename T, typename Shape>
vec3<T> sky(const Shape& shape, const ScatteringTables<T>& tables, const PathTraced& view) {
    return scattering_of_table<T, DefaultScene>(
               shape.atmosphere, view.eye<T>(), view.direction<T>(), view.to_sun<T>(), no_surface<T>(),
               TableHook<T, Shape>{shape, tables.rayleigh}, TableHook<T, Shape>{shape, tables.mie},
               TableHook<T, Shape>{shape, tables.multiple})
        .radiance;
}

/// One order's table seen at a view.
template <typename T, typename Shape>
vec3<T> order_at(const Shape& shape, const Table<vec3<T>>& order, const PathTraced& view) {
    return scattering_of_table<T, DefaultScene>(shape.atmosphere, view.eye<T>(), view.direction<T>(),
                                                view.to_sun<T>(), no_surface<T>(), NothingScattered{},
                                                NothingScattered{}, TableHook<T, Shape>{shape, order})
        .radiance;
}

std::vector<PathTraced> path_traced() {
    return read_path_traced(AIRLIGHT_TEST_DATA "/../../reference/data/earth.csv");
}

/// Errors of each order, of the classes of the sun, relative to that order.
struct OrderErrors {
    std::vector<double> orders[4][3];

    void print(const char* what) const {
        for (int order = 0; order < 4; ++order) {
            for (int sun = 0; sun < 3; ++sun) {
                const ErrorMetrics error = error_metrics(orders[order][sun]);
                std::printf("accuracy %s, order %d, %s: median %.4f, p95 %.4f, max %.4f (%zu)\n", what,
                            order + 1, sun_classes[sun].name, error.median, error.p95, error.largest,
                            orders[order][sun].size());
            }
        }
    }
    double median(int order, int sun) const {
        return error_metrics(orders[order - 1][sun]).median;
    }
    double p95(int order, int sun) const {
        return error_metrics(orders[order - 1][sun]).p95;
    }
};

template <typename T, typename Shape>
OrderErrors errors_of_orders(const Shape& shape) {
    const std::vector<PathTraced> views = path_traced();
    OrderErrors errors;
    const auto judge = [&](int order, const auto& radiance) {
        for (const PathTraced& view : views) {
            const double expected = view.orders[static_cast<std::size_t>(order - 1)];
            // Where an order is next to nothing, it is held against a thousandth of all light.
            const double scale = std::max(expected, 1e-3 * view.total);
            for (int sun = 0; sun < 3; ++sun) {
                if (sun_classes[sun].holds(view)) {
                    const double got = static_cast<double>(radiance(view)[view.channel]);
                    errors.orders[order - 1][sun].push_back(std::fabs(got - expected) / scale);
                }
            }
        }
    };
    ScatteringTables<T> tables =
        bake_scattering(shape, 4, OneAfterAnother{}, [&](int k, const Table<vec3<T>>& order) {
            judge(k, [&](const PathTraced& view) { return order_at(shape, order, view); });
        });
    for (vec3<T>& texel : tables.multiple.texels) {
        texel = vec3<T>(T(0));
    }
    judge(1, [&](const PathTraced& view) { return sky(shape, tables, view); });
    return errors;
}

/// Small tables: a test must be quick.
template <typename T>
BrunetonShape<T> small_bruneton(const Atmosphere<T>& atmosphere) {
    BrunetonShape<T> shape{atmosphere};
    shape.altitudes = 4;
    shape.views = 12;
    shape.suns = 6;
    shape.nus = 4;
    shape.irradiance_suns = 8;
    shape.irradiance_altitudes = 2;
    return shape;
}

template <typename T>
InscatterShape<T> small_inscatter(const Atmosphere<T>& atmosphere) {
    InscatterShape<T> shape{atmosphere};
    shape.altitudes = 4;
    shape.views = 12;
    shape.suns = 6;
    shape.irradiance_suns = 8;
    shape.irradiance_altitudes = 2;
    return shape;
}

template <typename T>
bool all_light(const Table<vec3<T>>& table) {
    for (const vec3<T>& x : table.texels) {
        for (int c = 0; c < 3; ++c) {
            if (!(std::isfinite(x[c]) && x[c] >= T(0))) {
                return false;
            }
        }
    }
    return true;
}

template <typename T>
double sum_of(const Table<vec3<T>>& table) {
    double sum = 0;
    for (const vec3<T>& x : table.texels) {
        sum += static_cast<double>(x.x + x.y + x.z);
    }
    return sum;
}

}  // namespace

TEST_SUITE_BEGIN("tables_scattering");

TEST_CASE("every order of the four-dimensional table is the path tracer's") {
    BrunetonShape<float> shape{earth<float>()};
    shape.altitudes = 12;
    shape.views = 48;
    const OrderErrors errors = errors_of_orders<float>(shape);
    errors.print("bruneton 12x48x32x8");
    // Modelling: linear filtering of a third of the altitudes and views of the usual table.
    CHECK(errors.median(1, 0) < 0.004);                    // measured: 0.0035
    CHECK(errors.p95(1, 0) < 0.023);                       // measured: 0.020
    const double median[5] = {0, 0, 0.011, 0.020, 0.031};  // measured: 0.0094, 0.0175, 0.0282
    for (int order = 2; order <= 4; ++order) {
        CHECK(errors.median(order, 0) < median[order]);
        CHECK(errors.p95(order, 0) < 0.065);     // measured: 0.057, 0.041, 0.059
        CHECK(errors.median(order, 1) < 0.145);  // 32 suns are too few for twilight (measured: 0.132)
    }
}

TEST_CASE(
    "order 1 of the three-dimensional table: exact where the azimuth says nothing, else an approximation") {
    // Our reading of a source that drops the azimuth between view and sun as if it did not matter. The
    // texel's own error, without interpolation: the sun at right angles to the view's azimuth, against the
    // azimuth that is there.
    const Atmosphere<double> planet = earth<double>();
    const auto error = [&](double elevation, double sun_elevation, double azimuth) {
        const vec3<double> direction = slope<double>(elevation, azimuth);
        const vec3<double> to_sun = slope<double>(sun_elevation);
        const auto light = [&](double nu) {
            const InScatter<double> apart =
                single_inscatter<double, Nodes<24>>(planet, 2.0, direction.z, to_sun.z, nu, false);
            const double at = dot_product(direction, to_sun);
            return rayleigh_phase(at) * apart.rayleigh.y +
                   cornette_shanks_phase(at, planet.mie_g) * apart.mie.y;
        };
        return light(direction.z * to_sun.z) / light(dot_product(direction, to_sun)) - 1;
    };
    for (const double azimuth : {0.0, 60.0, 180.0}) {
        CHECK(std::fabs(error(90, 5, azimuth)) < 1e-9);   // the zenith has no azimuth
        CHECK(std::fabs(error(10, 90, azimuth)) < 1e-9);  // nor has a sun in it
    }
    CHECK(std::fabs(error(2, 20, 90)) < 1e-9);  // the azimuth that the table is made for
    const double day = error(30, 30, 0);
    const double evening = error(2, 5, 0);
    const double against = error(2, 5, 180);
    const double dusk = error(2, 0, 0);
    std::printf(
        "accuracy inscatter texel, green: view 30 sun 30 ahead %+.4f; view 2 sun 5 ahead %+.4f, behind "
        "%+.4f; "
        "view 2 sun 0 ahead %+.4f\n",
        day, evening, against, dusk);
    // Modelling, the figures of docs/theory/scattering_orders.md.
    CHECK(std::fabs(day) < 3e-4);  // over 20 km the sun turns by a fifth of a degree
    CHECK(std::fabs(day) > 1e-5);  // but it is there
    CHECK(evening < -0.040);       // 4 %: ahead the air is nearer to noon than the table thinks
    CHECK(evening > -0.049);
    CHECK(against > 0.095);  // 10 %: and behind nearer to night
    CHECK(against < 0.110);
    CHECK(dusk < -0.345);  // 35 %: at sunset it matters
    CHECK(dusk > -0.360);
}

TEST_CASE("an eye that climbs from slice to slice of the three-dimensional table sees no step") {
    const Atmosphere<double> planet = earth<double>();
    const InscatterShape<double> shape = small_inscatter(planet);
    const ScatteringTables<double> tables = bake_scattering(shape, 1);
    for (int slice = 1; slice + 1 < shape.altitudes; ++slice) {
        const double share = double(slice) / (shape.altitudes - 1);
        const double altitude = share * share * planet.top_altitude;  // the mapping's square root
        for (const double mu : {0.2, 0.6, 1.0}) {
            const auto light = [&](double above) {
                return shape.read(tables.rayleigh, altitude + above, mu, 0.5, 0.5 * mu, false).y;
            };
            const double below = light(-1e-3);
            const double beyond = light(1e-3);
            CHECK(below > 0);
            // Modelling: 2 mm are 1e-7 of a texel, and the slice below is up to 30 times as bright.
            CHECK(std::fabs(beyond / below - 1) <= 3e-6);
            CHECK(light(-1000) > beyond);  // and yet the light does change
        }
    }
}

TEST_CASE("the three-dimensional table with all orders, against the path tracer") {
    InscatterShape<float> shape{earth<float>()};
    shape.views = 64;
    shape.suns = 32;
    const ScatteringTables<float> tables = bake_scattering(shape, 4);
    std::vector<double> errors[3];
    for (const PathTraced& view : path_traced()) {
        for (int sun = 0; sun < 3; ++sun) {
            if (sun_classes[sun].holds(view)) {
                const double got = static_cast<double>(sky(shape, tables, view)[view.channel]);
                errors[sun].push_back(std::fabs(got / view.sum_of_orders(1, 4) - 1));
            }
        }
    }
    for (int sun = 0; sun < 2; ++sun) {
        const ErrorMetrics error = error_metrics(errors[sun]);
        std::printf("accuracy inscatter 32x64x32, orders 1 to 4, %s: median %.4f, p95 %.4f, max %.4f\n",
                    sun_classes[sun].name, error.median, error.p95, error.largest);
    }
    // Modelling: the azimuth that is not there. Good for most of the day's sky, no good for twilight.
    CHECK(error_metrics(errors[0]).median < 0.01);
    CHECK(error_metrics(errors[0]).largest < 0.15);
    CHECK(error_metrics(errors[1]).median < 0.30);
}

TEST_CASE_TEMPLATE("no air, one substance, white ground, thick air: light is finite and never negative", T,
                   float, double) {
    const Atmosphere<T> planet = earth<T>();
    std::vector<Atmosphere<T>> worlds(6, planet);
    worlds[0].rayleigh_scattering = worlds[0].mie_scattering = worlds[0].mie_absorption =
        worlds[0].ozone_absorption = vec3<T>(T(0));
    worlds[1].rayleigh_scattering = vec3<T>(T(0));                        // aerosol only
    worlds[2].mie_scattering = worlds[2].mie_absorption = vec3<T>(T(0));  // molecules only
    worlds[3].ground_albedo = vec3<T>(T(1));
    worlds[4].ground_radius = T(2575e3);  // Titan's size, with an optical depth of hundreds
    worlds[4].top_altitude = T(600e3);
    worlds[4].rayleigh_scale_height = T(40e3);
    worlds[4].rayleigh_scattering = vec3<T>(T(1e-4L), T(3e-4L), T(1e-3L));
    worlds[4].mie_scale_height = T(60e3);
    worlds[4].mie_scattering = vec3<T>(T(5e-5L), T(4e-5L), T(2e-5L));
    worlds[4].mie_absorption = vec3<T>(T(1e-6L), T(1e-5L), T(4e-5L));
    worlds[5].rayleigh_scale_height = worlds[5].mie_scale_height = worlds[5].ozone_half_width = T(0);
    for (const Atmosphere<T>& world : worlds) {
        for (int orders = 1; orders <= 3; orders += 2) {
            const auto check = [&](const auto& shape) {
                const ScatteringTables<T> tables = bake_scattering(shape, orders);
                CHECK(all_light(tables.rayleigh));
                CHECK(all_light(tables.mie));
                CHECK(all_light(tables.multiple));
                CHECK(all_light(tables.irradiance));
                const vec3<T> most = vec3<T>(T(1));
                for (const vec3<T>& light : tables.irradiance.texels) {
                    // Energy: no more than the sun's own falls down, but for the interpolation of so few
                    // texels.
                    CHECK(light.x <= T(1.1L) * most.x);
                }
            };
            check(small_bruneton(world));
            check(small_inscatter(world));
        }
    }
    // Without air nothing is scattered.
    const ScatteringTables<T> none = bake_scattering(small_bruneton(worlds[0]), 2);
    for (std::size_t i = 0; i < none.rayleigh.texels.size(); ++i) {
        CHECK(none.rayleigh.texels[i] == vec3<T>(T(0)));
        CHECK(none.multiple.texels[i] == vec3<T>(T(0)));
    }
    // Molecules alone leave the aerosol's table empty.
    CHECK(sum_of(bake_scattering(small_bruneton(worlds[2]), 1).mie) == 0.0);  // exact: times 0
    CHECK(sum_of(bake_scattering(small_inscatter(worlds[2]), 1).mie) == 0.0);
}

TEST_CASE("the orders are told apart, add up to the table, and dwindle") {
    const Atmosphere<double> planet = earth<double>();
    const BrunetonShape<double> shape = small_bruneton(planet);
    std::vector<double> sums;
    Table<vec3<double>> sum = make_table<vec3<double>>(shape.width(), shape.height(), shape.depth());
    int calls = 0;
    const auto rows = [&](int count, const auto& body) {
        ++calls;
        OneAfterAnother{}(count, body);
    };
    const ScatteringTables<double> tables =
        bake_scattering(shape, 6, rows, [&](int order, const Table<vec3<double>>& radiance) {
            CHECK(order == static_cast<int>(sums.size()) + 2);
            sums.push_back(sum_of(radiance));
            for (std::size_t i = 0; i < sum.texels.size(); ++i) {
                sum.texels[i] += radiance.texels[i];
            }
        });
    CHECK(calls == passes_of_bake(6));
    REQUIRE(sums.size() == 5);
    CHECK(sum.texels == tables.multiple.texels);  // exact: added in the same order
    for (std::size_t i = 1; i < sums.size(); ++i) {
        CHECK(sums[i] < 0.6 * sums[i - 1]);  // the blue sky gives on a third to a half of its light each time
        CHECK(sums[i] > 0.05 * sums[i - 1]);
    }
    const ScatteringTables<double> once = bake_scattering(shape, 1, rows);
    CHECK(sum_of(once.multiple) == 0.0);
    CHECK(once.rayleigh.texels == tables.rayleigh.texels);
}

TEST_CASE("from orbit by night: dark where no air in sight is lit, and the limb glows where some is") {
    const Atmosphere<double> planet = earth<double>();
    BrunetonShape<double> shape = small_bruneton(planet);
    shape.views = 32;
    shape.suns = 16;
    shape.nus = 8;
    const ScatteringTables<double> tables = bake_scattering(shape, 1);
    const double top = planet.ground_radius + planet.top_altitude;
    const double eye_altitude = 400e3;
    // Over the limb towards the sun, so many degrees below the horizontal where the ray enters the air.
    const auto limb = [&](double sun_depth, auto&& look) {
        const double perigee = top * std::sqrt((1 - 0.175) * (1 + 0.175));
        const double from_nadir =
            std::asin(perigee / (planet.ground_radius + eye_altitude)) * 180 / pi<double>;
        const double turned = std::asin(perigee / top) * 180 / pi<double> - from_nadir;
        return look(standing(eye_altitude), slope<double>(from_nadir - 90),
                    slope<double>(-sun_depth - turned));
    };
    const auto by_table = [&](const Viewpoint<double>& eye, const vec3<double>& direction,
                              const vec3<double>& to_sun) {
        return scattering_of_table<double, DefaultScene>(
                   planet, eye, direction, to_sun, no_surface<double>(),
                   TableHook<double, BrunetonShape<double>>{shape, tables.rayleigh},
                   TableHook<double, BrunetonShape<double>>{shape, tables.mie})
            .radiance.y;
    };
    const auto exact = [&](const Viewpoint<double>& eye, const vec3<double>& direction,
                           const vec3<double>& to_sun) {
        return single_scattering<double>(planet, eye, direction, to_sun, no_surface<double>()).radiance.y;
    };
    CHECK(limb(35, exact) == 0.0);
    CHECK(limb(35, by_table) == 0.0);
    // 1e-7 of the day's limb (2.4e-9), which the few texels of this table smear: a deeper night has none.
    CHECK(limb(25, exact) > 1e-9);
    CHECK(limb(25, by_table) > 1e-9);
    CHECK(limb(25, by_table) < 1e-6);

    Random random(41);
    int dark = 0;
    double brightest = 0;
    for (int i = 0; i < 20000; ++i) {
        const Viewpoint<double> eye = standing(random.log_uniform(1, 2e6));
        const vec3<double> direction = slope<double>(random.uniform(-90, 20), random.uniform(0, 180));
        const vec3<double> to_sun = slope<double>(random.uniform(-90, -15));
        const AirRay<double> air = air_ray(planet, eye, direction, no_surface<double>());
        const SunOverLine<double> sun = sun_over_line(planet.ground_radius, eye, direction, to_sun);
        const double mu_s =
            (sun.perigee_height + air.along * sun.cos_theta) / (planet.ground_radius + air.altitude);
        if (air.in_air && mu_s < shape.lowest_sun) {
            ++dark;
            CHECK(exact(eye, direction, to_sun) == 0.0);
            brightest = std::fmax(brightest, by_table(eye, direction, to_sun));
        }
    }
    CHECK(dark > 5000);
    CHECK(brightest == 0.0);  // exact: the texels of the lowest suns hold nothing
}

TEST_CASE("an odd number of views counts as one more") {
    const Atmosphere<double> planet = earth<double>();
    const auto check = [](auto odd) {
        auto even = odd;
        odd.views = 11;
        even.views = 12;
        CHECK(odd.height() == 12);
        const ScatteringTables<double> a = bake_scattering(odd, 2);
        const ScatteringTables<double> b = bake_scattering(even, 2);
        CHECK(a.rayleigh.texels == b.rayleigh.texels);
        CHECK(a.multiple.texels == b.multiple.texels);
        // Straight up and straight down, the half of the one and of the other.
        for (const bool ground : {false, true}) {
            const double mu = ground ? -1 : 1;
            CHECK(odd.read(a.rayleigh, 1e4, mu, 0.5, mu * 0.5, ground) ==
                  even.read(b.rayleigh, 1e4, mu, 0.5, mu * 0.5, ground));
        }
    };
    check(small_bruneton(planet));
    check(small_inscatter(planet));
}

TEST_CASE("white ground brightens the sky, black ground does not") {
    Atmosphere<double> planet = earth<double>();
    double sums[2];
    for (int white = 0; white < 2; ++white) {
        planet.ground_albedo = vec3<double>(white);
        sums[white] = sum_of(bake_scattering(small_bruneton(planet), 3).multiple);
    }
    CHECK(sums[1] > 1.3 * sums[0]);
}

TEST_CASE("irradiance of the ground is the sky's radiance summed up by another rule") {
    const Atmosphere<double> planet = earth<double>();
    BrunetonShape<double> shape = small_bruneton(planet);
    shape.views = 32;
    shape.suns = 24;
    shape.irradiance_suns = 64;
    const ScatteringTables<double> tables = bake_scattering<Nodes<16>>(shape, 1);
    for (const double sun_elevation : {60.0, 20.0, 5.0}) {
        const vec3<double> to_sun = slope<double>(sun_elevation);
        double expected = 0;
        const int steps = 40;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                const double mu = (i + 0.5) / steps;
                const vec3<double> direction =
                    slope<double>(57.29577951308232 * std::asin(mu), 180.0 * (j + 0.5) / steps);
                expected +=
                    2 * pi<double> / (steps * steps) * mu *
                    single_scattering<double>(planet, standing(0.0), direction, to_sun, no_surface<double>())
                        .radiance.y;
            }
        }
        const double got =
            sample(tables.irradiance, altitude_sun_uv(planet, 0.0, to_sun.z, 64, shape.irradiance_altitudes))
                .y;
        CAPTURE(sun_elevation);
        CAPTURE(got / expected - 1);
        CHECK(std::fabs(got / expected - 1) < 0.05);  // modelling: a small table (measured: 0.03)
    }
}

TEST_SUITE_END();
