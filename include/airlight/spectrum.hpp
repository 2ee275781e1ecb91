#pragma once

#include <airlight/constants.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// The contrast at which a black object against the sky is just seen, Koschmieder's 2 % [1].
template <typename T>
inline constexpr T koschmieder_contrast = T(0.02L);

/// Contrast behind the meteorological optical range, 5 % [1].
template <typename T>
inline constexpr T optical_range_contrast = T(0.05L);

/// The sun's irradiance above the Earth's air over all wavelengths [W/m^2], at the mean distance: the
/// mean of 42 years by Gueymard, A reevaluation of the solar constant (2018).
template <typename T>
inline constexpr T total_solar_irradiance = T(1361.1L);

/// The same as the eye sees it [lx]: the spectrum of ASTM E490-00a, scaled to total_solar_irradiance,
/// through the CIE 1931 observer (tests/data/solar_light_table.py).
template <typename T>
inline constexpr T solar_illuminance = T(132829.62L);

/// The same as linear Rec. 709 red, green and blue [lx]; its luminance is solar_illuminance. As
/// solar_irradiance of compose it makes pictures in candela per square metre.
template <typename T>
inline constexpr vec3<T> solar_illuminance_rgb = vec3<T>(T(146098.85L), T(129654.20L), T(125202.84L));

/// The sun's spectral irradiance above the Earth's air [W/(m^2 nm)] at 680, 550 and 440 nm, the
/// wavelengths of earth(): means over 10 nm of the same spectrum.
template <typename T>
inline constexpr vec3<T> solar_spectral_irradiance = vec3<T>(T(1.48645L), T(1.86587L), T(1.82634L));

/// King's factor: how much more a gas of anisotropic molecules scatters.
///
///     F = (6 + 3 d) / (6 - 7 d)
///
/// Units:    depolarisation_ratio d [1]; result [1], 1 for d = 0.
/// Domain:   depolarisation_ratio in [0, 6/7).
/// Accuracy: under 4 ulp for d <= 0.1 (measured: 0.93).
/// Errors:   d = 6/7 divides by zero.
/// Source:   Bodhaine et al., On Rayleigh optical depth calculations (1999), equation 5.
template <typename T>
constexpr T king_factor(T depolarisation_ratio) {
    return (T(6) + T(3) * depolarisation_ratio) / (T(6) - T(7) * depolarisation_ratio);
}

/// Rayleigh scattering coefficient of a gas, without King's factor (multiply by it).
///
///     beta = 8 pi^3 (n^2 - 1)^2 / (3 N lambda^4),  n = 1 + refractivity
///
/// Takes n - 1, because float has no digits left for n = 1.00028.
///
/// Units:    refractivity [1]; number_density N [1/L^3]; wavelength [L]; result [1/L].
/// Domain:   number_density > 0, wavelength > 0; refractivity >= 0 (0: no scattering).
/// Accuracy: under 8 ulp (measured: 5.1 float, 2.9 double, 4.0 long double). Reading (n^2 + 2) / 3 as 1
///           makes air 0.04 % too strong.
/// Errors:   a number_density or wavelength of 0 divides by zero.
/// Source:   Bodhaine et al., On Rayleigh optical depth calculations (1999), with (n^2 + 2) / 3
///           read as 1; the squared form of Elek, Rendering parametrizable planetary
///           atmospheres (2009).
template <typename T>
constexpr T rayleigh_coefficient(T refractivity, T number_density, T wavelength) {
    const T contrast = refractivity * (T(2) + refractivity);
    const T ratio = contrast / (wavelength * wavelength);
    return T(8) / T(3) * pi<T> * pi<T> * pi<T> * ratio * (ratio / number_density);
}

/// Absorption that goes with a scattering coefficient and a single-scattering albedo.
///
///     absorption = scattering (1 - albedo) / albedo
///
/// The aerosol's scattering itself is the user's choice: a formula without wavelength has
/// the unit of 1/L^5 and is none.
///
/// Units:    scattering and result [1/L], spectra; single_scattering_albedo [1].
/// Domain:   scattering >= 0; single_scattering_albedo in (0, 1]; 0.9 is common for haze.
/// Accuracy: 3 roundoffs of absorption + scattering (measured: 2.0).
/// Errors:   an albedo of 0 divides by zero.
/// Source:   definition of the single-scattering albedo, scattering / extinction.
template <typename T>
vec3<T> absorption_from_albedo(const vec3<T>& scattering, T single_scattering_albedo) {
    return scattering * ((T(1) - single_scattering_albedo) / single_scattering_albedo);
}

/// Extinction coefficient of haze in which contrast falls to `contrast` at `visibility`.
///
///     extinction = -ln(contrast) / visibility
///
/// Units:    visibility [L]; contrast [1]; result [1/L].
/// Domain:   visibility > 0; contrast in (0, 1], koschmieder_contrast or optical_range_contrast.
/// Accuracy: under 2 ulp where log is within 1 (measured: 1.03).
/// Errors:   visibility 0 divides by zero.
/// Source:   Koschmieder (1924), as used in meteorology: 3.912 / V and 2.996 / V.
template <typename T>
T extinction_from_visibility(T visibility, T contrast) {
    return -glm::log(contrast) / visibility;
}

/// Angstrom's law: an aerosol coefficient at one wavelength over that at another.
///
///     beta(wavelength) / beta(reference) = (wavelength / reference)^-exponent
///
/// Units:    wavelength and reference_wavelength in one length unit [L]; exponent [1]; result [1].
/// Domain:   wavelengths > 0; any exponent, 1.3 for fine haze, near 0 for dust and cloud.
/// Accuracy: 3 roundoffs times 1 + |exponent| where pow is within 1 ulp (measured: 1.24).
/// Errors:   a reference_wavelength of 0 divides by zero.
/// Source:   Angstrom (1929), in the form used for aerosol optical depth.
template <typename T>
T angstrom_ratio(T wavelength, T reference_wavelength, T exponent) {
    return glm::pow(wavelength / reference_wavelength, -exponent);
}

}  // namespace airlight
