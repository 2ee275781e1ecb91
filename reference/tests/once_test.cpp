#include <cmath>
#include <cstdio>
#include <limits>

#include <doctest/doctest.h>

#include "reference/views.hpp"
#include "truth.hpp"

TEST_CASE("light that is scattered once is that of adaptive quadrature") {
    // World 2 of the study is the library's Earth.
    const study::World& world = study::worlds()[2];
    REQUIRE(world.air.rayleigh_scattering == airlight::earth<double>().rayleigh_scattering);
    std::uint64_t seed = 0;  // each its own, or all would be off the same way
    int values = 0;
    int far_off = 0;
    double squares = 0;
    for (const reference::View& view : reference::judged_views()) {
        const study::View same{"",
                               view.name(),
                               2,
                               {{view.altitude, reference::Vector(0, 0, 1)},
                                reference::direction_at(view.elevation, view.azimuth),
                                reference::direction_at(view.sun_elevation),
                                std::numeric_limits<double>::infinity()}};
        const airlight::vec3<double> expected = study::true_radiance(same).radiance;
        for (int channel = 0; channel < 3; ++channel) {
            const reference::Air air(world.air, world.ozone, channel);
            const reference::Estimate got =
                traced(air, view, 0, reference::Effort{40000, ++seed, 40, 1}).order[0];
            if (expected[channel] == 0) {
                CHECK(got.mean == 0);
                continue;
            }
            // The closed form of the way to the sun is good to 1e-6 where it is not all of the light.
            const double off =
                std::fabs(got.mean - expected[channel]) / (got.error + 1e-6 * expected[channel]);
            ++values;
            far_off += off > 3 ? 1 : 0;
            squares += off * off;
            CAPTURE(view.name());
            CAPTURE(channel);
            CHECK(off < 4.5);  // 1e-5 each; of groups of 40 means, whose spread is itself known to 11 %
        }
    }
    std::printf(
        "scattered once: %d values, %d more than 3 standard errors off, chi-square %.2f of its mean\n",
        values, far_off, squares / values);
    CHECK(values > 100);
    CHECK(far_off <= 3);            // 0.4 expected
    CHECK(squares / values < 1.6);  // 1 expected, with a spread of 0.13
}
