#pragma once

#include <airlight/habitat.hpp>
#include <airlight/habitat_mapping.hpp>

namespace airlight {

/// The air of a habitat of 8 km radius whose wall weighs as Earth's ground, with Earth's air at 15 degrees.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   Rama, for the radius; its air is not printed, so that of earth() is taken.
template <typename T>
HabitatAir<T> rama_air() {
    const T radius = T(8e3);
    return HabitatAir<T>{
        radius,
        spun_density_rise(spin_for_gravity(radius, T(9.81L)), T(287.05L), T(288.15L)),  // density_rise
        vec3<T>(T(5.802e-6L), T(13.558e-6L), T(33.1e-6L)),                              // rayleigh_scattering
        vec3<T>(T(3.996e-6L), T(3.996e-6L), T(3.996e-6L)),                              // mie_scattering
        vec3<T>(T(0.444e-6L), T(0.444e-6L), T(0.444e-6L)),                              // mie_absorption
        T(0.8L)                                                                         // mie_g
    };
}

/// The six strips of light of a habitat 48 km long: 11 km by 100 m each, of radiance 1.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   Rama, its scattering code: strips from 5 to 16 km of 24, two texels of 48 kept for 200 m on both
///           sides of each end.
template <typename T>
HabitatLights<T> rama_lights() {
    return HabitatLights<T>{
        T(24e3),                    // half_length
        T(5e3),                     // begin
        T(16e3),                    // end
        T(100),                     // width
        vec3<T>(T(1), T(1), T(1)),  // radiance
        T(200),                     // fine
        T(1) / T(12)                // fine_share
    };
}

}  // namespace airlight
