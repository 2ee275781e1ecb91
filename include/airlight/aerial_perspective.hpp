#pragma once

#include <airlight/compose.hpp>
#include <airlight/single_scattering.hpp>
#include <airlight/sun.hpp>

namespace airlight {

/// The sun's irradiance of a surface, through the air, with the sun setting behind the ground sphere.
///
/// Units:    place.altitude [L]; normal and to_sun unit vectors; sin_radius [1] of the sun's angular
///           radius; result [1], share of the solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   that of sunlight.
/// Accuracy: that of sunlight.
/// Errors:   none; a surface turned away gets 0.
/// Source:   Lambert's cosine law; sunlight.
template <typename T, typename Scene = DefaultScene>
vec3<T> sun_irradiance(const Atmosphere<T>& atmosphere, const Viewpoint<T>& place, const vec3<T>& normal,
                       const vec3<T>& to_sun, T sin_radius) {
    const T mu_s = glm::clamp(dot_product(place.up, to_sun), T(-1), T(1));
    const T facing = glm::max(dot_product(normal, to_sun), T(0));
    return facing * sunlight<T, Scene>(atmosphere, place.altitude, mu_s, sin_radius);
}

/// What the eye sees of a surface at a distance: its light dimmed by the air between, and that air's own.
///
/// The air's light is what it scatters up to the surface and no further, so aerosol in front of a near
/// wall hardly glows, and no light comes through it from behind. It is light scattered once: for every order
/// give compose what all_scattering returns.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; surface_radiance and
///           result [1/sr] per unit of solar irradiance above the air.
/// Shape:    surface_radiance and the result are spectra.
/// Domain:   that of single_scattering; surface_radiance >= 0.
/// Accuracy: that of single_scattering.
/// Errors:   none; distance 0 gives surface_radiance.
/// Source:   single_scattering, compose.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
vec3<T> aerial_perspective(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                           const vec3<T>& to_sun, T distance, const vec3<T>& surface_radiance,
                           const Visibility& visibility = Visibility{}) {
    const Scattered<T> air =
        single_scattering<T, Scene>(atmosphere, eye, direction, to_sun, distance, visibility);
    return compose(surface_radiance, air, vec3<T>(T(1), T(1), T(1)));
}

/// The same air with an aerosol that takes light and gives none back.
///
/// For aerial_perspective in the way of Leenman's shader, whose aerosol does not glow in front of
/// surfaces. Not physical: a haze that should be bright is dark.
///
/// Units:    those of the atmosphere.
/// Domain:   every atmosphere.
/// Accuracy: 1 roundoff.
/// Errors:   none.
/// Source:   Leenman, Atmospheric scattering explained (2021), the scattering function's allow_mie.
template <typename T>
Atmosphere<T> without_aerosol_glow(const Atmosphere<T>& atmosphere) {
    Atmosphere<T> dark = atmosphere;
    dark.mie_absorption = atmosphere.mie_absorption + atmosphere.mie_scattering;
    dark.mie_scattering = vec3<T>(T(0), T(0), T(0));
    return dark;
}

}  // namespace airlight
