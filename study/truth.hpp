#pragma once

// What single scattering is, by adaptive quadrature.

#include "views.hpp"

namespace study {

struct Truth {
    airlight::vec3<double> radiance;  ///< [1/sr] per unit of solar irradiance
    double doubt;                     ///< share of the largest channel that the quadrature is not sure of
};

/// The radiance of a view.
///
/// Shares nothing with airlight but the numbers of the atmosphere: positions are vectors from the
/// planet's centre in long double, columns are integrals of the density along the ray, none is in closed
/// form, and both integrals halve their parts until two rules agree. Parts begin where an integrand
/// has a corner or jumps: the closest approach, the ozone's shells, the edge of the planet's shadow, and
/// where the sun's rays graze a shell.
Truth true_radiance(const View& view);

}  // namespace study
