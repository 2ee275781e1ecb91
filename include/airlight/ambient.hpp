#pragma once

#include <airlight/numeric.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// Light that the air glows with everywhere, a crude stand-in for light scattered many times.
///
///     L = ambient_scattering C_R (1 - exp(-tau)) / tau
///
/// A thin ray gives ambient_scattering C_R; a thick one does not grow past what it lets through.
///
/// Units:    ambient_scattering [1/(L sr)] per unit of solar irradiance; rayleigh_column [L];
///           optical_depth [1] of the same ray; result [1/sr].
/// Shape:    ambient_scattering, optical_depth and the result are spectra.
/// Domain:   all >= 0.
/// Accuracy: 6 ulp.
/// Errors:   none; optical depth 0 gives the thin limit.
/// Source:   Leenman, Atmospheric scattering explained (2021), ambient term, there without the
///           last factor; the factor is the integral of exp(-s) over the ray's optical depth.
template <typename T>
vec3<T> ambient_radiance(const vec3<T>& ambient_scattering, T rayleigh_column, const vec3<T>& optical_depth) {
    const vec3<T> thin = ambient_scattering * rayleigh_column;
    const T red = optical_depth.x > T(0) ? one_minus_exp(optical_depth.x) / optical_depth.x : T(1);
    const T green = optical_depth.y > T(0) ? one_minus_exp(optical_depth.y) / optical_depth.y : T(1);
    const T blue = optical_depth.z > T(0) ? one_minus_exp(optical_depth.z) / optical_depth.z : T(1);
    return thin * vec3<T>(red, green, blue);
}

}  // namespace airlight
