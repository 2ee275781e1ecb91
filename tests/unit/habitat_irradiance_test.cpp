#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/habitat_irradiance.hpp>
#include <airlight/habitats.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// Even air, as thick in blue as that of Rama's wall.
HabitatAir<double> even_air() {
    HabitatAir<double> air = rama_air<double>();
    air.density_rise = 0;
    return air;
}

/// The definition, by midpoints over the strip's area: radiance, both cosines, what passes in even air.
vec3<double> by_area(const HabitatAir<double>& air, const LinearLight<double>& light,
                     const vec3<double>& place, const vec3<double>& normal) {
    const int along = 2000;
    const int across = 8;
    const vec3<double> side = glm::cross(light.normal, light.along);
    const vec3<double> extinction = air.rayleigh_scattering + air.mie_scattering + air.mie_absorption;
    const double cell = 2 * light.half_length / along * (light.width / across);
    vec3<double> sum(0);
    for (int i = 0; i < along; ++i) {
        for (int j = 0; j < across; ++j) {
            const vec3<double> point = light.centre +
                                       (2 * (i + 0.5) / along - 1) * light.half_length * light.along +
                                       ((j + 0.5) / across - 0.5) * light.width * side;
            const vec3<double> way = point - place;
            const double r = glm::length(way);
            const double here = std::max(glm::dot(way, normal) / r, 0.0);
            const double there = std::max(-glm::dot(way, light.normal) / r, 0.0);
            sum += cell * here * there / (r * r) * light.radiance * glm::exp(-r * extinction);
        }
    }
    return sum;
}

double worst_channel(const vec3<double>& got, const vec3<double>& exact) {
    const vec3<double> off = glm::abs(got / exact - vec3<double>(1));
    return std::max({off.x, off.y, off.z});
}

}  // namespace

TEST_SUITE_BEGIN("habitat_irradiance");

TEST_CASE_TEMPLATE("without air the irradiance is that of the strip alone", T, float, double) {
    Random random(670);
    HabitatAir<T> air = rama_air<T>();
    air.rayleigh_scattering = vec3<T>(T(0));
    air.mie_scattering = vec3<T>(T(0));
    air.mie_absorption = vec3<T>(T(0));
    const LinearLight<T> light = habitat_strip(air, rama_lights<T>(), 0);
    int lit = 0;
    for (int i = 0; i < 2000; ++i) {
        const double x = random.uniform(-24e3, 24e3);
        const double y = random.uniform(-5600, 5600);
        const double z = random.uniform(-5600, 5600);
        const vec3<T> place = vec3<T>(T(x), T(y), T(z));
        const vec3<T> normal = random.direction<T>();
        const vec3<T> got = strip_irradiance_in_air(air, light, place, normal, 1);
        const vec3<T> bare = strip_irradiance(light, place, normal);
        // Exact: all that passes is 1, and so is a mean of ones with any weights.
        CHECK(got == bare);
        lit += got.x > T(0) ? 1 : 0;
    }
    CHECK(lit > 900);  // half of all normals face away: 1000 of 2000
}

TEST_CASE("the irradiance of six strips is their sum, and none comes from behind") {
    const HabitatAir<double> air = rama_air<double>();
    const HabitatLights<double> lights = rama_lights<double>();
    const vec3<double> place(0, 0, -8000);
    const vec3<double> up(0, 0, 1);
    // In the middle both halves are alike: three strips, twice.
    vec3<double> half(0);
    for (int i = 0; i < 3; ++i) {
        half += strip_irradiance_in_air(air, habitat_strip(air, lights, i), place, up, 1);
    }
    CHECK(habitat_irradiance(air, lights, place, up, 1).x ==
          doctest::Approx(2 * half.x).epsilon(1e-12));             // roundoffs
    CHECK(habitat_irradiance(air, lights, place, -up, 1).x == 0);  // exact: every strip is behind the wall
    CHECK(habitat_irradiance(air, lights, place, up, 0).x == 0);   // no pieces
}

TEST_CASE("in even air the irradiance is the integral over the strip's area") {
    const HabitatAir<double> air = even_air();
    const HabitatLights<double> lights = rama_lights<double>();
    Random random(671);
    struct Place {
        LinearLight<double> light;
        vec3<double> position;
        vec3<double> normal;
        vec3<double> exact;
        bool whole;  ///< all of the strip stands above the surface's plane
    };
    std::vector<Place> places;
    for (int i = 0; i < 200; ++i) {
        const double x = random.uniform(-24e3, 24e3);
        const double angle = random.uniform(0, 6.2831853);
        const vec3<double> outward(0, std::cos(angle), std::sin(angle));
        const double from_axis = i % 2 == 0 ? 8000 : random.uniform(0, 7900);
        const vec3<double> position = vec3<double>(x, 0, 0) + from_axis * outward;
        const vec3<double> normal = i % 2 == 0 ? -outward : random.direction<double>();
        const LinearLight<double> light = habitat_strip(air, lights, random.below(6));
        const vec3<double> exact = by_area(air, light, position, normal);
        const vec3<double> to_begin = light.centre - light.half_length * light.along - position;
        const vec3<double> to_end = light.centre + light.half_length * light.along - position;
        const double lowest = std::min(glm::dot(to_begin, normal), glm::dot(to_end, normal));
        if (exact.x > 1e-3 * strip_view(light, position).solid_angle) {
            places.push_back({light, position, normal, exact, lowest > 0});
        }
    }
    CHECK(places.size() > 100);
    for (const int pieces : {1, 2, 8}) {
        std::vector<double> whole;
        std::vector<double> cut;
        for (const Place& place : places) {
            (place.whole ? whole : cut)
                .push_back(worst_channel(
                    strip_irradiance_in_air(air, place.light, place.position, place.normal, pieces),
                    place.exact));
        }
        std::printf(
            "irradiance by %d points: p95 %.3g %%, worst %.3g %%; of strips partly below p95 %.3g %%\n",
            4 * pieces, 100 * percentile(whole, 0.95), 100 * percentile(whole, 1),
            100 * percentile(cut, 0.95));
        CHECK(percentile(whole, 0.95) <= 0.001);  // docstring
        CHECK(percentile(cut, 0.95) <= 0.001);    // docstring
    }
}

TEST_SUITE_END();
