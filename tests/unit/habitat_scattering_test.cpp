#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/habitats.hpp>
#include <airlight/tables/habitat.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// The strips themselves, at 4 points each, and at 32.
template <int Pieces>
struct Computed {
    vec3<double> operator()(const HabitatAir<double>& air, const HabitatLights<double>& lights,
                            const vec3<double>& position) const {
        return habitat_mean_radiance(air, lights, position, Pieces);
    }
};

struct Ray {
    vec3<double> eye;
    vec3<double> direction;
    double distance;
};

/// From anywhere to the wall or a cap; half of the eyes within 100 m of the wall, where people are.
std::vector<Ray> rays(int count) {
    Random random(640);
    std::vector<Ray> all;
    for (int i = 0; i < count; ++i) {
        const double angle = random.uniform(0, 6.2831853);
        const double share = std::sqrt(random.uniform(0, 1));
        const double r = i % 2 == 0 ? 7999 * share : 8000 - random.log_uniform(2, 100);
        const double x = random.uniform(-23.9e3, 23.9e3);
        const vec3<double> eye(x, r * std::cos(angle), r * std::sin(angle));
        const vec3<double> direction = random.direction<double>();
        all.push_back({eye, direction, intersect_capped_cylinder(8000.0, 24e3, eye, direction).t_far});
    }
    return all;
}

template <int N>
struct Nodes : DefaultScene {
    static constexpr int nodes = N;
};

double worst_channel(const vec3<double>& got, const vec3<double>& exact) {
    return std::max(
        {std::fabs(got.x / exact.x - 1), std::fabs(got.y / exact.y - 1), std::fabs(got.z / exact.z - 1)});
}

double print(const char* what, std::vector<double> errors) {
    const double p95 = percentile(errors, 0.95);
    std::printf("%s: p50 %.3g %%, p95 %.3g %%, worst %.3g %%\n", what, 100 * percentile(errors, 0.5),
                100 * p95, 100 * percentile(errors, 1));
    return p95;
}

}  // namespace

TEST_SUITE_BEGIN("habitat_scattering");

TEST_CASE("the light of six strips is the sum of each one's, and the same from all six sides") {
    const HabitatAir<double> even = rama_air<double>();
    const HabitatLights<double> six = rama_lights<double>();
    const vec3<double> on_axis = habitat_mean_radiance(even, six, vec3<double>(0), 4);
    // In the middle of the axis all six are alike.
    const vec3<double> one = strip_mean_radiance(even, habitat_strip(even, six, 0), vec3<double>(0), 4);
    CHECK(on_axis.y == doctest::Approx(6 * one.y).epsilon(1e-9));  // roundoffs
    const vec3<double> place(3000, 2000, 1000);
    const double c = -0.5;
    const double s = std::sqrt(0.75);
    const vec3<double> turned(3000, 2000 * c - 1000 * s, 2000 * s + 1000 * c);
    CHECK(habitat_mean_radiance(even, six, turned, 4).z ==
          doctest::Approx(habitat_mean_radiance(even, six, place, 4).z).epsilon(1e-9));
}

TEST_CASE("marched and by nodes, computed and by tables, against the exact isotropic integral") {
    const HabitatAir<double> medium = rama_air<double>();
    const HabitatLights<double> six = rama_lights<double>();
    const Table<vec3<double>> light = bake_habitat_light(medium, six);
    const Table<vec3<double>> passed = bake_habitat_passed(medium, six);
    const Table<vec3<double>> small = bake_habitat_passed(medium, six, 25, 9, 9);
    const std::vector<Ray> all = rays(200);
    std::vector<vec3<double>> truth;
    for (const Ray& ray : all) {
        truth.push_back(habitat_scattering_marched(medium, six, ray.eye, ray.direction, ray.distance, 1500,
                                                   Computed<8>{}));
    }
    const auto measured = [&](const std::string& what, const auto& method) {
        std::vector<double> errors;
        for (std::size_t i = 0; i < all.size(); ++i) {
            errors.push_back(worst_channel(method(all[i]), truth[i]));
        }
        return print(what.c_str(), errors);
    };
    const auto marched = [&](const std::string& what, const auto& hook) {
        return measured("30 midpoints, " + what, [&](const Ray& ray) {
            return habitat_scattering_marched(medium, six, ray.eye, ray.direction, ray.distance, 30, hook);
        });
    };
    const auto by_nodes = [&](auto scene, const std::string& what, const auto& hook) {
        using Scene = decltype(scene);
        return measured(std::to_string(Scene::nodes) + " nodes, " + what, [&](const Ray& ray) {
            return habitat_scattering_by_nodes<double, Scene>(medium, six, ray.eye, ray.direction,
                                                              ray.distance, hook);
        });
    };
    marched("exact light", Computed<8>{});
    marched("4 points a strip", Computed<1>{});
    const double document = marched("table of light 49 x 33 x 33", HabitatLightTable<double>{&light});
    const double ours = marched("table of what passes 49 x 33 x 33", HabitatPassedTable<double>{&passed});
    marched("table of what passes 25 x 9 x 9", HabitatPassedTable<double>{&small});
    by_nodes(Nodes<6>{}, "exact light", Computed<8>{});
    by_nodes(Nodes<8>{}, "exact light", Computed<8>{});
    by_nodes(Nodes<10>{}, "exact light", Computed<8>{});
    by_nodes(Nodes<16>{}, "exact light", Computed<8>{});
    const double nodes =
        by_nodes(Nodes<10>{}, "table of what passes 49 x 33 x 33", HabitatPassedTable<double>{&passed});
    by_nodes(Nodes<10>{}, "table of what passes 25 x 9 x 9", HabitatPassedTable<double>{&small});
    // Modelling: what the test prints, with room for another compiler's last digits.
    CHECK(document <= 0.06);
    CHECK(ours <= 0.01);
    CHECK(nodes <= 0.01);
}

TEST_CASE("by hand: even light in thin even air is as much as the way is long") {
    const HabitatAir<double> thin{8000, 0, vec3<double>(1e-12), vec3<double>(0), vec3<double>(0), 0};
    const auto even = [](const auto&, const auto&, const auto&) { return vec3<double>(3, 2, 1); };
    const vec3<double> eye(0, 0, -7000);
    const vec3<double> direction(0, 0, 1);
    const vec3<double> marched =
        habitat_scattering_marched(thin, rama_lights<double>(), eye, direction, 1e4, 3, even);
    CHECK(marched.x == doctest::Approx(3 * 1e-12 * 1e4).epsilon(1e-7));  // depth 1e-8
    const vec3<double> by_nodes =
        habitat_scattering_by_nodes(thin, rama_lights<double>(), eye, direction, 1e4, even);
    CHECK(by_nodes.x ==
          doctest::Approx(3 * 1e-12 * 1e4).epsilon(1e-6));  // the nodes' own for an even integrand
    CHECK(habitat_scattering_marched(thin, rama_lights<double>(), eye, direction, 1e4, 0, even).x == 0);
    CHECK(habitat_scattering_by_nodes(thin, rama_lights<double>(), eye, direction, 0.0, even).x == 0);
}

TEST_SUITE_END();
