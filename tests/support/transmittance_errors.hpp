#pragma once

// How wrong a table of transmittances to space is.

#include <airlight/transmittance.hpp>
#include <cmath>
#include <vector>

#include "converted.hpp"
#include "error_metrics.hpp"
#include "samplers.hpp"

namespace airlight_test {

/// Relative errors of `to_space(atmosphere, altitude, mu)` against the closed form in double, over points in
/// the air and directions above their horizon: even, close to the ground, close to the horizon. The worst of
/// three channels counts; what is fainter than `faintest` is left out.
template <typename T, typename Scene, typename ToSpace>
std::vector<double> transmittance_errors(const airlight::Atmosphere<T>& atmosphere, const ToSpace& to_space,
                                         int count, double faintest = 1e-30) {
    const airlight::Atmosphere<double> air = converted<double>(atmosphere);
    Random random(1404);
    std::vector<double> errors;
    for (int i = 0; i < count; ++i) {
        const double share = random.unit();
        const T altitude = T(air.top_altitude * (i % 3 == 0 ? share * share * share : share));
        const double radius = air.ground_radius + double(altitude);
        const double horizon = -std::sqrt(double(altitude) * (air.ground_radius + radius)) / radius;
        const double up = random.unit();
        const double eighth = up * up * up;
        const double cosine = i % 4 == 0 ? eighth : horizon + (1 - horizon) * (i % 2 == 0 ? eighth : up);
        const T mu = T(cosine);
        if (airlight::behind_planet(air.ground_radius, double(altitude), double(mu)) ||
            airlight::behind_planet(atmosphere.ground_radius, altitude, mu)) {
            continue;  // rounding moved it
        }
        const airlight::vec3<double> expected =
            airlight::transmittance_to_space<double, Scene>(air, double(altitude), double(mu));
        const airlight::vec3<T> got = to_space(atmosphere, altitude, mu);
        double worst = 0;
        for (int channel = 0; channel < 3; ++channel) {
            if (expected[channel] >= faintest) {
                const double error = std::fabs(double(got[channel]) / expected[channel] - 1);
                worst = error > worst || std::isnan(error) ? error : worst;
            }
        }
        errors.push_back(worst);
    }
    return errors;
}

}  // namespace airlight_test
