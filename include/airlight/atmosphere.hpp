#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The coefficients of one atmosphere around a spherical planet, in the caller's length unit [L].
template <typename T>
struct Atmosphere {
    T ground_radius;              ///< [L] of the ground sphere
    T top_altitude;               ///< [L] the air ends here
    vec3<T> rayleigh_scattering;  ///< [1/L] at altitude 0
    T rayleigh_scale_height;      ///< [L]
    vec3<T> mie_scattering;       ///< [1/L] at altitude 0
    vec3<T> mie_absorption;       ///< [1/L] at altitude 0
    T mie_scale_height;           ///< [L]
    T mie_g;                      ///< [1] parameter of the aerosol's phase function, see mie_phase
    vec3<T> ozone_absorption;     ///< [1/L] where the profile is 1
    T ozone_altitude;             ///< [L] centre of the layer
    T ozone_half_width;           ///< [L]
    vec3<T> ground_albedo;        ///< [1]
};

/// The same atmosphere in another unit of length.
///
/// Units:    new_units_per_old_unit [1], for metres to kilometres 0.001.
/// Domain:   new_units_per_old_unit > 0.
/// Accuracy: 1 ulp per member; exact for powers of two.
/// Errors:   a factor of 0 divides by zero.
/// Source:   none.
template <typename T>
Atmosphere<T> rescaled(const Atmosphere<T>& atmosphere, T new_units_per_old_unit) {
    const T k = new_units_per_old_unit;
    return Atmosphere<T>{atmosphere.ground_radius * k,       atmosphere.top_altitude * k,
                         atmosphere.rayleigh_scattering / k, atmosphere.rayleigh_scale_height * k,
                         atmosphere.mie_scattering / k,      atmosphere.mie_absorption / k,
                         atmosphere.mie_scale_height * k,    atmosphere.mie_g,
                         atmosphere.ozone_absorption / k,    atmosphere.ozone_altitude * k,
                         atmosphere.ozone_half_width * k,    atmosphere.ground_albedo};
}

}  // namespace airlight
