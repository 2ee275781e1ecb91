#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/habitats.hpp>
#include <airlight/tables/habitat.hpp>

#include "error_metrics.hpp"
#include "samplers.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// Rama's cylinder, filled with as much of its air as said, of which nothing is absorbed.
HabitatAir<double> only_scattering(double share) {
    HabitatAir<double> air = rama_air<double>();
    air.rayleigh_scattering *= share;
    air.mie_scattering *= share;
    air.mie_absorption = vec3<double>(0);
    return air;
}

/// Power that six strips send, by Lambert's law.
double sent(const HabitatLights<double>& lights) {
    return 6 * pi<double> * lights.radiance.y * lights.width * (lights.end - lights.begin);
}

/// Integral over the wall and the caps of irradiance(position, normal), by midpoints over a sixth of the
/// turn, which stands for all.
template <typename Irradiance>
vec3<double> over_walls(const HabitatAir<double>& air, const HabitatLights<double>& lights,
                        const Irradiance& irradiance) {
    const int along = 96;
    const int around = 12;
    vec3<double> sum(0);
    for (int j = 0; j < around; ++j) {
        const double angle = (j + 0.5) / around * pi<double> / 3;
        const vec3<double> outward(0, std::cos(angle), std::sin(angle));
        const double turn = pi<double> / 3 / around;
        for (int i = 0; i < along; ++i) {
            const vec3<double> x((i + 0.5) / along * lights.half_length, 0, 0);
            sum += air.radius * turn * (lights.half_length / along) *
                   irradiance(x + air.radius * outward, -outward);
        }
        for (int i = 0; i < around; ++i) {
            const double from_axis = (i + 0.5) / around * air.radius;
            sum += from_axis * turn * (air.radius / around) *
                   irradiance(vec3<double>(lights.half_length, 0, 0) + from_axis * outward,
                              vec3<double>(-1, 0, 0));
        }
    }
    return 12.0 * sum;
}

/// What the walls receive of all light, straight and indirect, over what the strips send.
vec3<double> received_of_sent(const HabitatAir<double>& air, double albedo, int bounces) {
    const HabitatLights<double> lights = rama_lights<double>();
    const Table<vec3<double>> passed = bake_habitat_passed(air, lights, 25, 9, 9, 2);
    const HabitatPassedTable<double> straight{&passed};
    const HabitatIndirectTables<double> tables =
        bake_habitat_indirect(air, lights, vec3<double>(albedo), bounces, 17, 7, 5, 64, straight);
    const HabitatIrradianceTable<double> indirect{&air, &lights, &tables.irradiance};
    const vec3<double> all =
        over_walls(air, lights, [&](const vec3<double>& position, const vec3<double>& normal) {
            return habitat_irradiance(air, lights, position, normal, 1) + indirect(position);
        });
    return all / sent(lights);
}

bool is_light(const vec3<double>& light) {
    return light.x >= 0 && light.y >= 0 && light.z >= 0 && std::isfinite(light.x + light.y + light.z);
}

}  // namespace

TEST_SUITE_BEGIN("habitat_indirect");

TEST_CASE_TEMPLATE("the nearest wall faces the axis, the nearest cap the middle", T, float, double,
                   long double) {
    const HabitatAir<T> air = rama_air<T>();
    const HabitatLights<T> lights = rama_lights<T>();
    const auto normal = [&](T x, T y, T z) { return habitat_normal(air, lights, vec3<T>(x, y, z)); };
    // Exact: signs and quotients of equal numbers.
    CHECK(normal(T(100), T(0), T(-8000)) == vec3<T>(T(0), T(0), T(1)));
    CHECK(normal(T(100), T(4000), T(0)) == vec3<T>(T(0), T(-1), T(0)));
    CHECK(normal(T(24000), T(300), T(-400)) == vec3<T>(T(-1), T(0), T(0)));
    CHECK(normal(T(-24000), T(300), T(-400)) == vec3<T>(T(1), T(0), T(0)));
    CHECK(normal(T(0), T(0), T(0)) == vec3<T>(T(0), T(-1), T(0)));  // on the axis, as said
    CHECK(normal(T(20000), T(0), T(0)) == vec3<T>(T(-1), T(0), T(0)));
    CHECK(normal(T(24000), T(0), T(-8000)) == vec3<T>(T(0), T(0), T(1)));  // in the corner the wall
    const vec3<T> slant = normal(T(0), T(3000), T(-4000));
    CHECK(double(slant.y) == doctest::Approx(-0.6).epsilon(1e-6));  // float's roundoffs
    CHECK(double(slant.z) == doctest::Approx(0.8).epsilon(1e-6));
}

TEST_CASE_TEMPLATE("a ray ends on the wall or on a cap, and there faces back", T, float, double) {
    const HabitatAir<T> air = rama_air<T>();
    const HabitatLights<T> lights = rama_lights<T>();
    const HabitatWall<T> wall = habitat_wall(air, lights, vec3<T>(T(0)), vec3<T>(T(0), T(0), T(1)));
    CHECK(wall.distance == T(8000));  // exact: the root of 8000^2
    CHECK(wall.normal == vec3<T>(T(0), T(0), T(-1)));
    const HabitatWall<T> cap =
        habitat_wall(air, lights, vec3<T>(T(4000), T(1), T(2)), vec3<T>(T(1), T(0), T(0)));
    CHECK(cap.distance == T(20000));
    CHECK(cap.position == vec3<T>(T(24000), T(1), T(2)));
    CHECK(cap.normal == vec3<T>(T(-1), T(0), T(0)));
    const HabitatWall<T> missed =
        habitat_wall(air, lights, vec3<T>(T(0), T(9000), T(0)), vec3<T>(T(1), T(0), T(0)));
    CHECK(missed.distance == T(0));
    Random random(690);
    for (int i = 0; i < 5000; ++i) {
        const double x = random.uniform(-23.9e3, 23.9e3);
        const double angle = random.uniform(0, 6.2831853);
        const double r = i % 4 == 0 ? 8000 : random.uniform(0, 8000);
        const vec3<T> eye(T(x), T(r * std::cos(angle)), T(r * std::sin(angle)));
        const vec3<T> direction = random.direction<T>();
        const HabitatWall<T> there = habitat_wall(air, lights, eye, direction);
        CHECK(there.distance >= T(0));
        const double left = std::min(24e3 - std::fabs(double(there.position.x)),
                                     8e3 - std::hypot(double(there.position.y), double(there.position.z)));
        CHECK(std::fabs(left) <= 24e3 * 16 * std::numeric_limits<T>::epsilon());  // roundoffs of 24 km
        if (there.distance > T(1)) {
            CHECK(double(glm::dot(there.normal, direction)) < 0);
        }
    }
}

TEST_CASE_TEMPLATE("directions of the lattice have length 1 and average as the sphere does", T, float,
                   double) {
    const double roundoff = double(std::numeric_limits<T>::epsilon()) / 2;
    double worst_length = 0;
    for (const int count : {1, 2, 7, 128, 4096}) {
        vec3<double> first(0);
        vec3<double> square(0);
        vec3<double> mixed(0);
        vec3<double> fourth(0);
        for (int i = 0; i < count; ++i) {
            const vec3<double> d(sphere_lattice<T>(i, count));
            worst_length = std::max(worst_length, std::fabs(glm::length(d) - 1) / roundoff);
            first += d / double(count);
            square += d * d / double(count);
            mixed += d * vec3<double>(d.y, d.z, d.x) / double(count);
            fourth += d * d * d * d / double(count);
        }
        const auto off = [](const vec3<double>& got, double exact) {
            const vec3<double> apart = glm::abs(got - vec3<double>(exact));
            return std::max({apart.x, apart.y, apart.z});
        };
        std::printf(
            "%d directions: means off by %.2g, of squares %.2g, of products %.2g, of fourth powers %.2g\n",
            count, off(first, 0), off(square, 1.0 / 3), off(mixed, 0), off(fourth, 0.2));
        if (count >= 128) {
            // Equal areas, one point each: an error of 1 / count, and of 2 / count where a power doubles it.
            CHECK(off(first, 0) <= 2.0 / count);
            CHECK(off(square, 1.0 / 3) <= 2.0 / count);  // as above
            CHECK(off(mixed, 0) <= 2.0 / count);         // as above
            CHECK(off(fourth, 0.2) <= 2.0 / count);      // as above
        }
    }
    std::printf("length of a direction: off by %.3g roundoffs at most\n", worst_length);
    CHECK(worst_length <= 8 + 4e-15 / roundoff);  // docstring
}

TEST_CASE("in float the lattice turns as in double") {
    double worst = 0;
    for (const int count : {128, 1000, 4096}) {
        for (int i = 0; i < count; ++i) {
            const vec3<double> d = sphere_lattice<double>(i, count);
            const vec3<double> f(sphere_lattice<float>(i, count));
            const double sine = std::hypot(d.y, d.z);
            worst = std::max(worst, std::fabs(f.y * d.z - f.z * d.y) / (sine * std::hypot(f.y, f.z)));
        }
    }
    std::printf("angle of a direction in float: off by %.3g at most\n", worst);
    CHECK(worst <= 1.6e-3);  // half an ulp of 2531 turns, and the golden section's own 4095 times
}

TEST_CASE("by hand: a wall under even light is as bright as its albedo has it, seen through no air") {
    const HabitatAir<double> air = only_scattering(0);
    const HabitatLights<double> lights = rama_lights<double>();
    const auto hidden = [](const vec3<double>&, const vec3<double>&) { return 0.0; };
    const auto even = [](const vec3<double>&) { return vec3<double>(2, 3, 4); };
    const vec3<double> albedo(0.5, 0.25, 1);
    const vec3<double> place(3000, 0, -8000);
    const vec3<double> wall =
        habitat_wall_radiance(air, lights, albedo, place, vec3<double>(0, 0, 1), hidden, even);
    CHECK(wall.x == doctest::Approx(0.5 * 2 / pi<double>).epsilon(1e-12));  // roundoffs, as below
    CHECK(wall.y == doctest::Approx(0.25 * 3 / pi<double>).epsilon(1e-12));
    const vec3<double> seen = habitat_radiance(air, lights, albedo, vec3<double>(0), vec3<double>(0, 0, -1),
                                               hidden, BareHabitatLight{}, even);
    CHECK(seen.z == doctest::Approx(4 / pi<double>).epsilon(1e-12));
    // So is a place among such walls: the mean is the walls' radiance, irradiance pi times it.
    const HabitatIndirect<double> inside =
        gathered_habitat_light(air, lights, albedo, place, 512, hidden, BareHabitatLight{}, even);
    CHECK(inside.mean.x == doctest::Approx(1 / pi<double>).epsilon(1e-12));
    CHECK(inside.irradiance.x == doctest::Approx(1).epsilon(2e-3));  // half the sphere by 512 directions
}

TEST_CASE("by hand: air that sees nothing but itself adds its own light to what passes of the wall") {
    const HabitatAir<double> air = rama_air<double>();
    const HabitatLights<double> lights = rama_lights<double>();
    const vec3<double> eye(0, 0, -7000);
    const vec3<double> direction(0, 0.6, 0.8);
    const auto even = [](const auto&, const auto&, const auto&) { return vec3<double>(1); };
    const auto lit = [](const vec3<double>&) { return vec3<double>(1); };
    const HabitatWall<double> wall = habitat_wall(air, lights, eye, direction);
    const vec3<double> behind =
        habitat_radiance(air, lights, vec3<double>(0), eye, direction, AlwaysSeen{}, even);
    // Exact: without albedo the wall adds zero.
    CHECK(behind == habitat_scattering_by_nodes(air, lights, eye, direction, wall.distance, even));
    const vec3<double> all =
        habitat_radiance(air, lights, vec3<double>(0.5), eye, direction, AlwaysSeen{}, even, lit);
    const vec3<double> direct = habitat_irradiance(air, lights, wall.position, wall.normal, 1);
    const vec3<double> expected = behind + habitat_transmittance(air, eye, wall.position) *
                                               (0.5 / pi<double> * (direct + vec3<double>(1)));
    CHECK(all.z == doctest::Approx(expected.z).epsilon(1e-12));  // roundoffs
}

TEST_CASE("energy is kept: with albedo a the walls receive what the strips send over 1 - a") {
    const double a = 0.5;
    const int bounces = 8;
    for (const double air : {0.0, 1.0}) {
        const vec3<double> got = received_of_sent(only_scattering(air), a, bounces);
        const double expected = 1 / (1 - a);
        std::printf(
            "%g of Rama's air, albedo %g, %d bounces: walls receive %.4g %.4g %.4g of what is sent, "
            "all would be %.4g\n",
            air, a, bounces, got.x, got.y, got.z, expected);
        // What 8 bounces leave and the tables' own: as printed 0.3 %, 0.6 % of the blue light in air.
        const double left = 0.015;
        CHECK(std::fabs(got.x / expected - 1) <= left);
        CHECK(std::fabs(got.y / expected - 1) <= left);
        CHECK(std::fabs(got.z / expected - 1) <= left);
    }
}

TEST_CASE("few directions are as good as many where light is as smooth as walls send it") {
    const HabitatAir<double> air = rama_air<double>();
    const HabitatLights<double> lights = rama_lights<double>();
    Random random(691);
    std::vector<vec3<double>> places;
    for (int i = 0; i < 20; ++i) {
        const double x = random.uniform(-23e3, 23e3);
        const double angle = random.uniform(0, 6.2831853);
        const double r = i % 2 == 0 ? 7999 : random.uniform(0, 7900);
        places.push_back(vec3<double>(x, r * std::cos(angle), r * std::sin(angle)));
    }
    const auto gathered = [&](const vec3<double>& place, int directions) {
        return gathered_habitat_light(air, lights, vec3<double>(0.3), place, directions);
    };
    std::vector<HabitatIndirect<double>> exact;
    for (const vec3<double>& place : places) {
        exact.push_back(gathered(place, 4096));
    }
    for (const int directions : {32, 128, 512}) {
        std::vector<double> mean;
        std::vector<double> irradiance;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const HabitatIndirect<double> got = gathered(places[i], directions);
            mean.push_back(std::fabs(got.mean.y / exact[i].mean.y - 1));
            irradiance.push_back(std::fabs(got.irradiance.y / exact[i].irradiance.y - 1));
        }
        const double p95 = std::max(percentile(mean, 0.95), percentile(irradiance, 0.95));
        std::printf("%d directions: mean p95 %.3g %%, worst %.3g %%; irradiance p95 %.3g %%, worst %.3g %%\n",
                    directions, 100 * percentile(mean, 0.95), 100 * percentile(mean, 1),
                    100 * percentile(irradiance, 0.95), 100 * percentile(irradiance, 1));
        if (directions >= 128) {
            CHECK(p95 <= (directions == 128 ? 0.03 : 0.01));  // docstring
        }
    }
}

TEST_CASE("absurd habitats have indirect light that is finite and not negative") {
    const HabitatLights<double> lights = rama_lights<double>();
    for (const double share : {0.0, 1.0, 1e4}) {
        for (const double rise : {0.0, 1.0}) {
            HabitatAir<double> air = only_scattering(share);
            air.density_rise *= rise;
            for (const double albedo : {0.0, 1.0}) {
                for (const vec3<double>& place :
                     {vec3<double>(0), vec3<double>(3e3, 0, -8e3), vec3<double>(10e3, 8e3, 0),
                      vec3<double>(24e3, 0, 0), vec3<double>(-24e3, 8e3, 0)}) {
                    for (const int directions : {0, 1, 16}) {
                        const HabitatIndirect<double> got =
                            gathered_habitat_light(air, lights, vec3<double>(albedo), place, directions);
                        CHECK(is_light(got.mean));
                        CHECK(is_light(got.irradiance));
                        const bool dark = directions == 0 || (albedo == 0 && share == 0);
                        if (dark) {
                            CHECK(got.mean == vec3<double>(0));  // exact: nothing is added
                            CHECK(got.irradiance == vec3<double>(0));
                        }
                    }
                }
                for (const int bounces : {0, 1}) {
                    const HabitatIndirectTables<double> tables =
                        bake_habitat_indirect(air, lights, vec3<double>(albedo), bounces, 3, 2, 2, 8);
                    for (const vec3<double>& texel : tables.mean.texels) {
                        CHECK(is_light(texel));
                        CHECK((bounces > 0 || texel == vec3<double>(0)));
                    }
                    for (const vec3<double>& texel : tables.irradiance.texels) {
                        CHECK(is_light(texel));
                    }
                }
            }
        }
    }
}

TEST_SUITE_END();
