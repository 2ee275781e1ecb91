#pragma once

#include <airlight/compose.hpp>
#include <airlight/single_scattering.hpp>
#include <airlight/sun.hpp>

namespace airlight {

/// What the eye sees where nothing but sky lies behind the air: the air's light, and the sun's disc
/// through it.
///
/// The air's light comes from the caller, by whatever method. The sun is hidden behind the planet, edge
/// by edge as it sets.
///
/// Units:    direction and to_sun unit vectors; air as single_scattering returns it for no_surface();
///           result [1/sr] per unit of solar irradiance above the air. Times solar_illuminance_rgb it is in
///           cd/m^2.
/// Shape:    the result is a spectrum.
/// Domain:   every viewpoint up to 1e12 m from an Earth; that of sun_radiance.
/// Accuracy: that of air and of sun_radiance.
/// Errors:   none; where the ray ends on the ground sphere, the light of the air in front of it.
/// Source:   the radiative transfer equation along a ray, its formal solution.
template <typename T>
vec3<T> sky_with_sun(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                     const vec3<T>& to_sun, const SunDisc<T>& sun, const Scattered<T>& air) {
    const vec3<T> disc = sun_radiance(sun, direction, to_sun);
    if (disc.x + disc.y + disc.z <= T(0)) {
        return air.radiance;
    }
    if (air_ray(atmosphere, eye, direction, no_surface<T>()).reaches_ground) {
        return air.radiance;
    }
    return compose(disc, air, vec3<T>(T(1), T(1), T(1)));
}

/// Radiance of the sky in a direction, for a pixel that shows no surface: light scattered once, and the
/// sun. For light of every order give sky_with_sun what all_scattering returns.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; result [1/sr] per
///           unit of solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   that of single_scattering and sun_radiance.
/// Accuracy: that of single_scattering and sun_radiance.
/// Errors:   none.
/// Source:   single_scattering, sky_with_sun.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
vec3<T> sky_radiance(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                     const vec3<T>& to_sun, const SunDisc<T>& sun,
                     const Visibility& visibility = Visibility{}) {
    const Scattered<T> air =
        single_scattering<T, Scene>(atmosphere, eye, direction, to_sun, no_surface<T>(), visibility);
    return sky_with_sun(atmosphere, eye, direction, to_sun, sun, air);
}

}  // namespace airlight
