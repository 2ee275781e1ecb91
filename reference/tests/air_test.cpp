#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "reference/air.hpp"
#include "support/presets.hpp"

using namespace reference;

namespace {

/// Chi-square of counts in bins of equal cosine against the shares they should have, over the degrees of
/// freedom; 1 on the average.
double chi_square(const std::vector<double>& cosines, const std::vector<double>& shares) {
    std::vector<double> counts(shares.size(), 0.0);
    for (const double c : cosines) {
        const auto bin = static_cast<std::size_t>((c + 1) / 2 * static_cast<double>(shares.size()));
        counts[std::min(bin, shares.size() - 1)] += 1;
    }
    double sum = 0;
    double used = -1;  // the counts add up
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double expected = shares[i] * static_cast<double>(cosines.size());
        if (expected >= 10) {
            sum += (counts[i] - expected) * (counts[i] - expected) / expected;
            used += 1;
        }
    }
    return sum / used;
}

}  // namespace

TEST_CASE("air scatters into directions as its phase functions say") {
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 1);
    const Vector forward = glm::normalize(Vector(0.3, -0.5, 0.8));
    for (const double altitude : {0.0, 3e3, 2e4}) {
        const Coefficients here = air.at(altitude);
        constexpr int bins = 40;
        std::vector<double> shares;
        for (int i = 0; i < bins; ++i) {
            double share = 0;
            for (int j = 0; j < 200; ++j) {
                const double cosine = -1 + 2 * (i + (j + 0.5) / 200) / bins;
                share += 2 * airlight::pi<double> * air.phase(here, cosine) * 2 / bins / 200;
            }
            shares.push_back(share);
        }
        Random random(1, 0);
        std::vector<double> cosines;
        for (int i = 0; i < 200000; ++i) {
            cosines.push_back(glm::dot(air.scattered(here, forward, random), forward));
        }
        const double got = chi_square(cosines, shares);
        std::printf("directions at %.0f m: chi-square %.2f of its mean\n", altitude, got);
        CHECK(got < 1.9);  // 39 degrees of freedom: above that once in 1000 seeds
    }
}

TEST_CASE("a turned direction keeps its angle, and every azimuth comes as often") {
    Random random(2, 0);
    for (const Vector& axis : {Vector(0, 0, 1), Vector(0, 0, -1), glm::normalize(Vector(1, 2, -3))}) {
        std::vector<double> around;
        const Vector side = glm::normalize(glm::cross(axis, Vector(0.2, 0.9, 0.1)));
        for (int i = 0; i < 20000; ++i) {
            const double cosine = 2 * random() - 1;
            const Vector out = turned(axis, cosine, random);
            CHECK(std::fabs(glm::length(out) - 1) < 1e-14);          // rounding of a square root
            CHECK(std::fabs(glm::dot(out, axis) - cosine) < 1e-13);  // rounding of a dozen products
            const double across = std::sqrt(1 - cosine * cosine);
            if (across > 0.1) {
                around.push_back(std::acos(std::clamp(glm::dot(out, side) / across, -1.0, 1.0)) /
                                     airlight::pi<double> * 2 -
                                 1);
            }
        }
        CHECK(chi_square(around, std::vector<double>(20, 0.05)) <
              2.3);  // 19 degrees of freedom: once in 1000
    }
}

TEST_CASE("flights meet the air as often as the closed form says") {
    for (const support::Preset& preset : support::presets()) {
        for (const int channel : {0, 2}) {
            const Air air(preset.air, preset.ozone, channel);
            const Vector start(0, 0, air.ground_radius() + 500);
            for (const double elevation : {90.0, 10.0, 0.5, -0.2}) {
                const double e = elevation * airlight::pi<double> / 180;
                const Vector direction(std::cos(e), 0, std::sin(e));
                Random random(3, static_cast<std::uint64_t>(channel));
                const int flights = 20000;
                int escaped = 0;
                for (int i = 0; i < flights; ++i) {
                    escaped += air.fly(start, direction, random).end == End::escaped ? 1 : 0;
                }
                const double expected = air.to_space(start, direction);
                const double spread = std::sqrt(expected * (1 - expected) / flights);
                CAPTURE(preset.name);
                CAPTURE(elevation);
                // Once in 15000 seeds, and there are 40 of them; the closed form is good to 1e-5.
                CHECK(std::fabs(static_cast<double>(escaped) / flights - expected) <= 4 * spread + 1e-5);
            }
        }
    }
}

TEST_CASE("a flight ends where it should: on the ground, at the top, in the air") {
    const Air air(airlight::earth<double>(), airlight::ozone_tent, 2);
    Random random(4, 0);
    int ends[3] = {0, 0, 0};
    for (int i = 0; i < 20000; ++i) {
        const Vector start =
            turned(Vector(0, 0, 1), 2 * random() - 1, random) * (air.ground_radius() + 1e5 * random());
        const Vector direction = turned(Vector(0, 0, 1), 2 * random() - 1, random);
        const Flight flight = air.fly(start, direction, random);
        const double radius = glm::length(flight.position);
        ends[static_cast<int>(flight.end)] += 1;
        if (flight.end == End::ground) {
            CHECK(std::fabs(radius - air.ground_radius()) < 1e-6);  // [m] rounding of a radius
        } else if (flight.end == End::escaped) {
            CHECK(std::fabs(radius - air.top_radius()) < 1e-6);
        } else {
            CHECK(radius > air.ground_radius());
            CHECK(radius < air.top_radius());
        }
        // It flew straight ahead.
        CHECK(glm::dot(flight.position - start, direction) >= -1e-6);
    }
    CHECK(ends[0] > 1000);
    CHECK(ends[1] > 1000);
    CHECK(ends[2] > 1000);
}
