#include "reference/habitat_table.hpp"

#include <airlight/habitat_indirect.hpp>
#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>

#include "table.hpp"

using namespace reference;

TEST_CASE("habitat: the committed table has the judged rays, and another seed agrees with it") {
    const std::vector<airlight_test::Row> rows = airlight_test::read_table(HABITAT_TABLE);
    const Habitat habitat{airlight::rama_air<double>(), airlight::rama_lights<double>(), Vector(0.3), false};
    const std::vector<HabitatRay> rays = judged_habitat_rays(habitat);
    REQUIRE(rows.size() == 3 * rays.size());
    Habitat even = habitat;
    even.isotropic = true;
    double squares = 0;
    int values = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const airlight_test::Row& row = rows[i];
        const HabitatRay& ray = rays[i / 3];
        CAPTURE(i);
        CHECK(row.text("kind") == ray.kind);
        const auto number = [&](const std::string& column) {
            return static_cast<double>(row.expected(column));
        };
        const Vector eye(number("x"), number("y"), number("z"));
        const Vector direction(number("dx"), number("dy"), number("dz"));
        CHECK(glm::length(eye - ray.eye) <= 1e-4);              // nine printed digits of 24 km
        CHECK(glm::length(direction - ray.direction) <= 1e-8);  // of 1
        const int channel = static_cast<int>(number("channel"));
        CHECK(channel == static_cast<int>(i % 3));
        const Vector end = ray.eye + ray.distance * ray.direction;
        const Vector normal = airlight::habitat_normal(habitat.air, habitat.lights, end);
        const auto compare = [&](const std::string& column, const Estimate& again) {
            const double settled =
                1e-4 * again.mean;  // hardly left to chance: errors of even points are no normal ones
            const double error = std::hypot(std::hypot(again.error, number(column + "_error")), settled);
            const double off = (again.mean - number(column)) / error;
            squares += off * off;
            ++values;
            CAPTURE(column);
            CHECK(std::fabs(off) < 5);  // 1e-6 each, were the error known; it is known to 11 %
        };
        const std::uint64_t seed = 7000000 + i;
        const auto air = [&](const Habitat& medium, int orders, std::uint64_t walks) {
            return habitat_air_light(medium, channel, ray.eye, ray.direction, ray.distance, orders, walks,
                                     seed);
        };
        compare("once", air(habitat, 1, 2000));
        compare("evenly", air(even, 1, 2000));
        compare("all", air(habitat, every_order, 1000));
        compare("straight", habitat_surface_irradiance(habitat, channel, end, normal, 0, 2000, seed));
        compare("irradiance",
                habitat_surface_irradiance(habitat, channel, end, normal, every_order, 1000, seed));
    }
    std::printf("the habitat's table, walked again: %d values, chi-square %.2f of its mean\n", values,
                squares / values);
    CHECK(squares / values < 1.4);  // 1 expected; the spread of 960 such squares is 0.05, of known errors
}
