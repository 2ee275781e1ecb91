#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Density of a well-mixed gas or aerosol relative to its value at the ground.
///
///     rho(h) = exp(-h / H)
///
/// Units:    altitude and scale_height in one length unit [L]; result [1].
/// Domain:   scale_height >= 0; every altitude, below the ground it counts as 0.
/// Accuracy: 2 roundoffs times 1 + 2 altitude / scale_height (measured: 0.5 float, 0.9 long double).
/// Errors:   none; a layer of scale height 0 holds nothing and gives 0.
/// Source:   the barometric formula at constant temperature.
template <typename T>
T exponential_density(T altitude, T scale_height) {
    return scale_height > T(0) ? glm::exp(-glm::max(altitude, T(0)) / scale_height) : T(0);
}

/// Density of a layer that rises and falls linearly, relative to its peak.
///
///     rho(h) = max(0, 1 - |h - centre| / half_width)
///
/// Units:    altitude, centre and half_width in one length unit [L]; result [1].
/// Domain:   half_width >= 0; every altitude, below the ground it counts as 0.
/// Accuracy: 2 roundoffs times 1 + (altitude + centre) / half_width (measured: 0.1).
/// Errors:   none; a layer of half width 0 holds nothing and gives 0.
/// Source:   Bruneton, Precomputed Atmospheric Scattering (2017), ozone profile of demo.cc.
template <typename T>
T tent_density(T altitude, T centre, T half_width) {
    const T offset = glm::abs(glm::max(altitude, T(0)) - centre);
    return half_width > T(0) ? glm::max(T(1) - offset / half_width, T(0)) : T(0);
}

/// Density of a layer with a Lorentz profile, relative to its peak.
///
///     rho(h) = 1 / (1 + ((h - centre) / half_width)^2)
///
/// Units:    altitude, centre and half_width in one length unit [L]; result [1].
/// Domain:   half_width >= 0; every altitude, below the ground it counts as 0.
/// Accuracy: 4 roundoffs times the condition |f| + sum |df/dx| |x| (measured: 0.5).
/// Errors:   none; a layer of half width 0 holds nothing and gives 0.
/// Source:   Leenman, Atmospheric scattering explained (2021), ozone profile.
template <typename T>
T lorentzian_density(T altitude, T centre, T half_width) {
    const T offset = glm::max(altitude, T(0)) - centre;
    const T scaled = half_width > T(0) ? offset / half_width : T(0);
    return half_width > T(0) ? T(1) / (T(1) + scaled * scaled) : T(0);
}

}  // namespace airlight
