#pragma once

#include <airlight/atmosphere.hpp>

namespace airlight {

/// Earth with an ozone layer, at 680, 550 and 440 nm. The default.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   the numbers of Bruneton (2017), demo.cc: Rayleigh 1.24062e-6 / m at 1 um, aerosol optical
///           depth 5.328e-3 of albedo 0.9, 300 Dobson units of ozone in a tent; the top at 100 km
///           as in Hillaire's demo of A Scalable and Production Ready Sky (2020).
template <typename T>
Atmosphere<T> earth() {
    return Atmosphere<T>{
        T(6360e3),                                          // ground_radius
        T(100e3),                                           // top_altitude
        vec3<T>(T(5.802e-6L), T(13.558e-6L), T(33.1e-6L)),  // rayleigh_scattering
        T(8e3),                                             // rayleigh_scale_height
        vec3<T>(T(3.996e-6L), T(3.996e-6L), T(3.996e-6L)),  // mie_scattering
        vec3<T>(T(0.444e-6L), T(0.444e-6L), T(0.444e-6L)),  // mie_absorption
        T(1.2e3),                                           // mie_scale_height
        T(0.8L),                                            // mie_g, a mean cosine of 0.844
        vec3<T>(T(0.65e-6L), T(1.881e-6L), T(0.085e-6L)),   // ozone_absorption
        T(25e3),                                            // ozone_altitude
        T(15e3),                                            // ozone_half_width
        vec3<T>(T(0.1L), T(0.1L), T(0.1L))                  // ground_albedo
    };
}

/// Earth as in the CS562 deferred renderer: strong haze, no ozone.
///
/// The document's extinction is scattering / 0.9, which we read as absorption = scattering / 9.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   Deferred atmospheric scattering, a CS562 project report: coefficients per kilometre
///           and g; radii, heights and albedo are chosen here, the report leaves them to its user.
template <typename T>
Atmosphere<T> cs562_earth() {
    return Atmosphere<T>{
        T(6371e3),                                      // ground_radius, chosen
        T(100e3),                                       // top_altitude, chosen
        vec3<T>(T(5.8e-6L), T(13.5e-6L), T(33.1e-6L)),  // rayleigh_scattering
        T(8e3),                                         // rayleigh_scale_height, chosen
        vec3<T>(T(20e-6L), T(20e-6L), T(20e-6L)),       // mie_scattering
        vec3<T>(T(2.2222222222222222222e-6L), T(2.2222222222222222222e-6L),
                T(2.2222222222222222222e-6L)),  // mie_absorption
        T(1.2e3),                               // mie_scale_height, chosen
        T(0.76L),                               // mie_g, a mean cosine of 0.810
        vec3<T>(T(0), T(0), T(0)),              // ozone_absorption, none
        T(25e3),                                // ozone_altitude, unused
        T(15e3),                                // ozone_half_width, unused
        vec3<T>(T(0.1L), T(0.1L), T(0.1L))      // ground_albedo, chosen
    };
}

/// Earth as in the notes on precomputed scattering after Elek: clear air, no ozone. The Rayleigh
/// triple is that of n = 1.0003 and N = 2.545e25 / m^3 at 650, 510 and 475 nm.
///
/// The notes print both absorption = scattering / 0.9 and an extinction that contains it, an albedo
/// of 0.474; we read extinction = scattering / 0.9, an albedo of 0.9, as the works they follow do.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   Notes on precomputed atmospheric scattering in Unity: coefficients and heights; radii,
///           g and albedo are chosen here, the notes give none.
template <typename T>
Atmosphere<T> elek_earth() {
    return Atmosphere<T>{
        T(6371e3),                                       // ground_radius, chosen
        T(100e3),                                        // top_altitude, chosen
        vec3<T>(T(6.55e-6L), T(17.3e-6L), T(23.0e-6L)),  // rayleigh_scattering
        T(8e3),                                          // rayleigh_scale_height
        vec3<T>(T(2e-6L), T(2e-6L), T(2e-6L)),           // mie_scattering
        vec3<T>(T(0.22222222222222222222e-6L), T(0.22222222222222222222e-6L),
                T(0.22222222222222222222e-6L)),  // mie_absorption
        T(1.2e3),                                // mie_scale_height
        T(0.76L),                                // mie_g, chosen
        vec3<T>(T(0), T(0), T(0)),               // ozone_absorption, none
        T(25e3),                                 // ozone_altitude, unused
        T(15e3),                                 // ozone_half_width, unused
        vec3<T>(T(0.1L), T(0.1L), T(0.1L))       // ground_albedo, chosen
    };
}

/// Earth as in Leenman's shader. Its ozone is a Lorentz curve times the Rayleigh density: compile
/// the scene with ozone = ozone_lorentzian.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   Leenman, Atmospheric scattering explained (2021); albedo chosen here. The shader's
///           aerosol does not absorb.
template <typename T>
Atmosphere<T> leenman_earth() {
    return Atmosphere<T>{
        T(6371e3),                                       // ground_radius
        T(100e3),                                        // top_altitude
        vec3<T>(T(5.5e-6L), T(13.0e-6L), T(22.4e-6L)),   // rayleigh_scattering
        T(8e3),                                          // rayleigh_scale_height
        vec3<T>(T(21e-6L), T(21e-6L), T(21e-6L)),        // mie_scattering
        vec3<T>(T(0), T(0), T(0)),                       // mie_absorption
        T(1.2e3),                                        // mie_scale_height
        T(0.7L),                                         // mie_g
        vec3<T>(T(20.4e-6L), T(49.7e-6L), T(1.95e-6L)),  // ozone_absorption
        T(30e3),                                         // ozone_altitude
        T(4e3),                                          // ozone_half_width
        vec3<T>(T(0.1L), T(0.1L), T(0.1L))               // ground_albedo, chosen
    };
}

/// Mars with its usual dust, at 680, 550 and 440 nm; the dust is the aerosol.
///
/// The Rayleigh triple (19.9, 13.6, 5.75)e-6 that many programs carry is not used: it falls towards
/// the blue, as no gas does, and is a hundred times too strong.
///
/// Units:    metres.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T.
/// Errors:   none.
/// Source:   Rayleigh by rayleigh_coefficient and king_factor with n - 1 = 3.37e-6, N = 2.05e23 / m^3
///           and depolarisation 0.09 as in CosmoScout VR's Mars; its scale height from NASA's Mars
///           fact sheet; radius, dust (optical depth 0.44 at 550 nm, single-scattering albedo 0.933,
///           0.845, 0.690, mean cosine 0.70 at 550 nm, scale height) from CalcMySky's mars.atmo, which
///           follows Ockert-Bell et al. (1997).
template <typename T>
Atmosphere<T> mars() {
    return Atmosphere<T>{
        T(3389.5e3),  // ground_radius
        T(100e3),     // top_altitude, chosen: e^-9 of the air lies above
        vec3<T>(T(0.10006e-6L), T(0.23379e-6L), T(0.57078e-6L)),  // rayleigh_scattering
        T(11.1e3),                                                // rayleigh_scale_height
        vec3<T>(T(40.0e-6L), T(34.71e-6L), T(27.11e-6L)),         // mie_scattering
        vec3<T>(T(2.86e-6L), T(6.37e-6L), T(12.18e-6L)),          // mie_absorption
        T(10.8e3),                                                // mie_scale_height
        T(0.635L),                                                // mie_g, a mean cosine of 0.70
        vec3<T>(T(0), T(0), T(0)),                                // ozone_absorption, none
        T(25e3),                                                  // ozone_altitude, unused
        T(15e3),                                                  // ozone_half_width, unused
        vec3<T>(T(0.36L), T(0.18L), T(0.08L))                     // ground_albedo, bright regions
    };
}

}  // namespace airlight
