#include "air.hpp"

#include <airlight/airlight.hpp>
#include <algorithm>
#include <cmath>

#include "support/presets.hpp"

namespace reference {
using namespace airlight;

Air::Air(const Atmosphere<double>& atmosphere, int ozone, int channel)
    : atmosphere_(atmosphere), ozone_(ozone), channel_(channel) {
    const double top = atmosphere.top_altitude;
    std::vector<double> altitudes = {0, top};
    // A quarter of the thinnest scale height at the bottom, wider and wider upwards.
    double step = 0.25 * std::min(std::max(atmosphere.mie_scale_height, 1e-3 * top),
                                  std::max(atmosphere.rayleigh_scale_height, 1e-3 * top));
    for (double altitude = step; altitude < top; altitude += step) {
        altitudes.push_back(altitude);
        step *= 1.2;
    }
    for (const double edge : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const double altitude = atmosphere.ozone_altitude + edge * atmosphere.ozone_half_width;
        if (altitude > 0 && altitude < top) {
            altitudes.push_back(altitude);
        }
    }
    std::sort(altitudes.begin(), altitudes.end());
    for (const double altitude : altitudes) {
        shells_.push_back(atmosphere.ground_radius + altitude);
    }
    for (std::size_t i = 1; i < altitudes.size(); ++i) {
        // What falls exponentially is largest at the bottom; the layer is, at an end or at its centre.
        const double low = altitudes[i - 1];
        const double high = altitudes[i];
        const double middle = std::clamp(atmosphere.ozone_altitude, low, high);
        const double layer = std::max({profile(low), profile(middle), profile(high)});
        const double molecules =
            ozone_ == ozone_lorentzian ? exponential_density(low, atmosphere.rayleigh_scale_height) : 1.0;
        const Coefficients bottom = at(low);
        majorant_.push_back(bottom.rayleigh + bottom.mie +
                            atmosphere.mie_absorption[channel] *
                                exponential_density(low, atmosphere.mie_scale_height) +
                            atmosphere.ozone_absorption[channel] * layer * molecules);
    }
}

double Air::profile(double altitude) const {
    if (ozone_ == ozone_none) {
        return 0;
    }
    return ozone_ == ozone_tent
               ? tent_density(altitude, atmosphere_.ozone_altitude, atmosphere_.ozone_half_width)
               : lorentzian_density(altitude, atmosphere_.ozone_altitude, atmosphere_.ozone_half_width);
}

Coefficients Air::at(double altitude) const {
    const double molecules = exponential_density(altitude, atmosphere_.rayleigh_scale_height);
    const double aerosol = exponential_density(altitude, atmosphere_.mie_scale_height);
    const double layer = profile(altitude) * (ozone_ == ozone_lorentzian ? molecules : 1.0);
    return Coefficients{
        atmosphere_.rayleigh_scattering[channel_] * molecules, atmosphere_.mie_scattering[channel_] * aerosol,
        atmosphere_.mie_absorption[channel_] * aerosol + atmosphere_.ozone_absorption[channel_] * layer};
}

double Air::phase(const Coefficients& air, double cos_theta) const {
    return (air.rayleigh * rayleigh_phase(cos_theta) +
            air.mie * cornette_shanks_phase(cos_theta, atmosphere_.mie_g)) /
           air.scattering();
}

Vector Air::scattered(const Coefficients& air, const Vector& direction, Random& random) const {
    const bool by_molecules = random() * air.scattering() < air.rayleigh;
    const double cosine =
        by_molecules ? sample_rayleigh_phase(random()) : sample_cornette_shanks(atmosphere_.mie_g, random);
    return turned(direction, cosine, random);
}

double Air::passed(double rayleigh, double mie, double ozone) const {
    return std::exp(-(atmosphere_.rayleigh_scattering[channel_] * rayleigh +
                      (atmosphere_.mie_scattering[channel_] + atmosphere_.mie_absorption[channel_]) * mie +
                      atmosphere_.ozone_absorption[channel_] * ozone));
}

double Air::to_space(const Vector& position, const Vector& direction) const {
    const double radius = glm::length(position);
    const double altitude = std::clamp(radius - ground_radius(), 0.0, atmosphere_.top_altitude);
    const double mu = std::clamp(glm::dot(position, direction) / radius, -1.0, 1.0);
    if (behind_planet(ground_radius(), altitude, mu)) {
        return 0;
    }
    return support::with_ozone(ozone_, [&](auto scene) {
        const Column<double> air = column_to_space<double, decltype(scene)>(atmosphere_, altitude, mu);
        return passed(air.rayleigh, air.mie, air.ozone);
    });
}

double Air::along(const Vector& position, const Vector& direction, double distance) const {
    const double radius = glm::length(position);
    const double altitude = std::clamp(radius - ground_radius(), 0.0, atmosphere_.top_altitude);
    const double mu = std::clamp(glm::dot(position, direction) / radius, -1.0, 1.0);
    return support::with_ozone(ozone_, [&](auto scene) {
        const Column<double> air = column<double, decltype(scene)>(atmosphere_, altitude, mu, distance);
        return passed(air.rayleigh, air.mie, air.ozone);
    });
}

Flight Air::fly(Vector position, const Vector& direction, Random& random) const {
    double radius = glm::length(position);
    const auto above = std::upper_bound(shells_.begin(), shells_.end(), radius);
    auto shell = std::clamp<std::ptrdiff_t>(above - shells_.begin() - 1, 0,
                                            static_cast<std::ptrdiff_t>(majorant_.size()) - 1);
    for (;;) {
        const auto i = static_cast<std::size_t>(shell);
        const double rise = glm::dot(position, direction);
        const double square = glm::dot(position, position);
        const double under = rise * rise - (square - shells_[i] * shells_[i]);
        const bool sinks = rise < 0 && under > 0;
        const double over = std::max(rise * rise - (square - shells_[i + 1] * shells_[i + 1]), 0.0);
        const double edge = std::max(sinks ? -rise - std::sqrt(under) : -rise + std::sqrt(over), 0.0);
        const double free = majorant_[i] > 0 ? -std::log1p(-random()) / majorant_[i] : edge;
        if (free >= edge) {
            position += edge * direction;
            shell += sinks ? -1 : 1;
            if (shell < 0) {
                return Flight{End::ground, position * (ground_radius() / glm::length(position))};
            }
            if (shell == static_cast<std::ptrdiff_t>(majorant_.size())) {
                return Flight{End::escaped, position};
            }
            continue;
        }
        position += free * direction;
        radius = glm::length(position);
        if (random() * majorant_[i] < at(radius - ground_radius()).extinction()) {
            return Flight{End::met_air, position};
        }
    }
}

}  // namespace reference
