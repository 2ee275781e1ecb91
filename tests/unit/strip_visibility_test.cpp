// What stands between a strip of light and a place: a ball, through the hook of everything that has it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/habitat_indirect.hpp>
#include <airlight/habitats.hpp>

#include "error_metrics.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// A ball that lets no light pass.
struct Ball {
    vec3<double> centre;
    double radius;

    double operator()(const vec3<double>& light_position, const vec3<double>& position) const {
        const vec3<double> way = light_position - position;
        const double share = glm::clamp(glm::dot(centre - position, way) / glm::dot(way, way), 0.0, 1.0);
        return glm::length(position + share * way - centre) > radius ? 1.0 : 0.0;
    }
};

const HabitatAir<double> air = rama_air<double>();
const HabitatLights<double> lights = rama_lights<double>();

/// The strip overhead of places at negative y.
LinearLight<double> strip() {
    return habitat_strip(air, lights, 0);
}

/// By midpoints over the strip's area: integral of what a ball lets pass times weight(unit way to the light).
template <typename Weight>
vec3<double> by_area(const vec3<double>& place, const Ball& ball, const Weight& weight) {
    const LinearLight<double> light = strip();
    const int along = 3000;
    const int across = 4;
    const vec3<double> side = glm::cross(light.normal, light.along);
    const double cell = 2 * light.half_length / along * (light.width / across);
    vec3<double> sum(0);
    for (int i = 0; i < along; ++i) {
        for (int j = 0; j < across; ++j) {
            const vec3<double> point = light.centre +
                                       (2 * (i + 0.5) / along - 1) * light.half_length * light.along +
                                       ((j + 0.5) / across - 0.5) * light.width * side;
            const vec3<double> way = point - place;
            const double r = glm::length(way);
            const double solid_angle = cell * std::max(-glm::dot(way, light.normal) / r, 0.0) / (r * r);
            sum += solid_angle * ball(point, place) * light.radiance *
                   habitat_transmittance(air, point, place) * weight(way / r);
        }
    }
    return sum;
}

/// Balls that wander along below the strip, 2 km over a place on the other wall. The first hides nothing.
std::vector<Ball> balls() {
    std::vector<Ball> all{{vec3<double>(0, 0, 7000), 1}};
    for (int i = 0; i < 24; ++i) {
        all.push_back({vec3<double>(9e3 + 150 * i, -6e3, 0), 300});
    }
    return all;
}

const vec3<double> place(10e3, -7999, 0);
const vec3<double> up(0, 1, 0);

/// The largest difference between shares hidden, by `computed(ball)` and by `exact(ball)`.
template <typename Computed, typename Exact>
double worst_share(const char* what, int points, const Computed& computed, const Exact& exact) {
    const std::vector<Ball> all = balls();
    const vec3<double> open = exact(all[0]);
    const vec3<double> open_computed = computed(all[0]);
    double worst = 0;
    double most_hidden = 0;
    for (const Ball& ball : all) {
        const double hidden = 1 - exact(ball).y / open.y;
        worst = std::max(worst, std::fabs(1 - computed(ball).y / open_computed.y - hidden));
        most_hidden = std::max(most_hidden, hidden);
    }
    std::printf("%s, %d points: share hidden up to %.3g, off by %.3g at most\n", what, points, most_hidden,
                worst);
    CHECK(most_hidden > 0.2);  // the balls do stand in the way
    return worst;
}

}  // namespace

TEST_SUITE_BEGIN("strip_visibility");

TEST_CASE("what a ball hides of a strip's light on a surface is the integral's share") {
    const auto exact = [](const Ball& ball) {
        return by_area(place, ball, [](const vec3<double>& to_light) {
            return vec3<double>(std::max(glm::dot(to_light, up), 0.0));
        });
    };
    const auto off = [&](int pieces) {
        return worst_share(
            "irradiance", 4 * pieces,
            [&](const Ball& ball) { return strip_irradiance_in_air(air, strip(), place, up, pieces, ball); },
            exact);
    };
    // A point is there or hidden: an edge is off by up to half the largest weight, two edges by both.
    CHECK(off(1) <= 0.33);        // weight 0.326 of the inner points
    CHECK(off(4) <= 0.33 / 4);    // a quarter of it for each of four pieces
    CHECK(off(64) <= 0.33 / 64);  // and so on
}

TEST_CASE("what a ball hides of a strip's light in the air is the integral's share") {
    const vec3<double> direction = glm::normalize(vec3<double>(1, 2, -1));
    const double density = habitat_density(air, place);
    const auto exact_source = [&](const Ball& ball) {
        return by_area(place, ball, [&](const vec3<double>& to_light) {
            return habitat_scattering(air, density, glm::dot(to_light, direction));
        });
    };
    const auto exact_mean = [](const Ball& ball) {
        return by_area(place, ball, [](const vec3<double>&) { return vec3<double>(1 / (4 * pi<double>)); });
    };
    for (const int pieces : {1, 4, 64}) {
        const double source = worst_share(
            "source", 4 * pieces,
            [&](const Ball& ball) { return strip_source(air, strip(), place, direction, pieces, ball); },
            exact_source);
        const double mean = worst_share(
            "mean radiance", 4 * pieces,
            [&](const Ball& ball) { return strip_mean_radiance(air, strip(), place, pieces, ball); },
            exact_mean);
        CHECK(source <= 0.4 / pieces);  // weight 0.326 of a point, by a phase function that is not even
        CHECK(mean <= 0.33 / pieces);   // weight 0.326 of a point
    }
}

TEST_CASE("the air of a ray is dark in a ball's shadow, by strips alone and by all six") {
    // Along the axis, through the shadow that a ball on the way to the strip throws.
    const Ball ball{vec3<double>(10e3, 4000, 0), 900};
    const vec3<double> eye(2e3, 0, 0);
    const vec3<double> direction(1, 0, 0);
    const double distance = 16e3;
    const auto by_steps = [&](const auto& source) {
        const int steps = 2000;
        vec3<double> sum(0);
        for (int i = 0; i < steps; ++i) {
            const vec3<double> q = eye + (i + 0.5) / steps * distance * direction;
            sum += distance / steps * habitat_transmittance(air, eye, q) * source(q);
        }
        return sum;
    };
    const auto of_strip = [&](const auto& visibility) {
        return by_steps(
            [&](const vec3<double>& q) { return strip_source(air, strip(), q, direction, 32, visibility); });
    };
    const double dark = of_strip(ball).y;
    const double open = of_strip(AlwaysSeen{}).y;
    std::printf("air of one strip: the ball takes %.3g of it\n", 1 - dark / open);
    CHECK(dark < 0.9 * open);  // the shadow is no small thing
    const double nodes = strip_scattering(air, strip(), eye, direction, distance, 32, ball).y;
    std::printf("by 8 nodes %.3g\n", 1 - nodes / open);
    // Nodes stand in the shadow or beside it: an edge costs up to half a node's share, 0.18 of all.
    CHECK(std::fabs(nodes - dark) <= 0.09 * open);

    const auto of_six = [&](const auto& visibility) {
        return [visibility](const auto& medium, const auto& six, const vec3<double>& position) {
            return habitat_mean_radiance(medium, six, position, 8, visibility);
        };
    };
    const double marched =
        habitat_scattering_marched(air, lights, eye, direction, distance, 2000, of_six(ball)).y;
    const double all =
        habitat_scattering_marched(air, lights, eye, direction, distance, 2000, of_six(AlwaysSeen{})).y;
    const double few = habitat_scattering_by_nodes(air, lights, eye, direction, distance, of_six(ball)).y;
    const double steps =
        habitat_scattering_marched(air, lights, eye, direction, distance, 30, of_six(ball)).y;
    std::printf("air of six strips: the ball takes %.3g of it, by 30 midpoints %.3g, by 8 nodes %.3g\n",
                1 - marched / all, 1 - steps / all, 1 - few / all);
    CHECK(marched < 0.97 * all);                      // one strip of six, a part of it
    CHECK(std::fabs(steps - marched) <= 0.01 * all);  // a step is a thirtieth, a strip a sixth of the light
    CHECK(std::fabs(few - marched) <= 0.03 * all);    // half a node's share of one strip's light
}

TEST_CASE("each of six strips is asked, and what is hidden altogether gives nothing") {
    const auto of_front = [](const vec3<double>& light_position, const vec3<double>&) {
        return light_position.x > 0 ? 1.0 : 0.0;
    };
    const auto nothing = [](const vec3<double>&, const vec3<double>&) { return 0.0; };
    vec3<double> front(0);
    vec3<double> front_mean(0);
    for (int i = 0; i < 3; ++i) {
        front += strip_irradiance_in_air(air, habitat_strip(air, lights, i), place, up, 2);
        front_mean += strip_mean_radiance(air, habitat_strip(air, lights, i), place, 2);
    }
    // Exact: the same sums in the same order, and zeros.
    CHECK(habitat_irradiance(air, lights, place, up, 2, of_front) == front);
    CHECK(habitat_mean_radiance(air, lights, place, 2, of_front) == front_mean);
    CHECK(habitat_irradiance(air, lights, place, up, 2, nothing) == vec3<double>(0));
    CHECK(habitat_mean_passed(air, lights, place, 2, nothing) == vec3<double>(0));
    const vec3<double> albedo(0.5);
    CHECK(habitat_wall_radiance(air, lights, albedo, place, up, nothing) == vec3<double>(0));
    const auto no_light = [](const auto&, const auto&, const auto&) { return vec3<double>(0); };
    CHECK(gathered_habitat_light(air, lights, albedo, place, 16, nothing, no_light).mean == vec3<double>(0));
    CHECK(gathered_habitat_light(air, lights, albedo, place, 16, of_front, no_light).mean.y > 0);
}

TEST_SUITE_END();
