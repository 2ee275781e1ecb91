#pragma once

// Worlds that no preset describes.

#include <airlight/atmospheres.hpp>

namespace airlight_test {

/// The same world without a molecule in its air, nor anything else.
template <typename T>
airlight::Atmosphere<T> airless(airlight::Atmosphere<T> world) {
    const airlight::vec3<T> none(T(0));
    world.rayleigh_scattering = world.mie_scattering = none;
    world.mie_absorption = world.ozone_absorption = none;
    return world;
}

/// Small and in thick haze, with air that reaches far up: Titan without its methane.
template <typename T>
airlight::Atmosphere<T> titan() {
    airlight::Atmosphere<T> air = airlight::earth<T>();
    air.ground_radius = T(2575e3L);
    air.top_altitude = T(400e3L);
    air.rayleigh_scale_height = T(40e3L);
    air.rayleigh_scattering = airlight::vec3<T>(T(2e-6L), T(5e-6L), T(12e-6L));
    air.mie_scale_height = T(30e3L);
    air.mie_scattering = airlight::vec3<T>(T(20e-6L));
    air.mie_absorption = airlight::vec3<T>(T(5e-6L), T(10e-6L), T(30e-6L));
    air.ozone_absorption = airlight::vec3<T>(T(0));
    return air;
}

}  // namespace airlight_test
