#pragma once

#include <airlight/single_scattering.hpp>

namespace airlight {

/// What the eye sees: the surface's light through the air, and the air's own.
///
///     L = L_surface T + radiance E_sun
///
/// Units:    surface_radiance and result in one unit of radiance, solar_irradiance in that unit
///           times [sr]; scattered as single_scattering_marched returns it.
/// Shape:    surface_radiance and solar_irradiance are spectra.
/// Domain:   all >= 0.
/// Accuracy: 3 ulp.
/// Errors:   none.
/// Source:   the radiative transfer equation along a ray, its formal solution.
template <typename T>
vec3<T> compose(const vec3<T>& surface_radiance, const Scattered<T>& scattered,
                const vec3<T>& solar_irradiance) {
    return surface_radiance * scattered.transmittance + scattered.radiance * solar_irradiance;
}

}  // namespace airlight
