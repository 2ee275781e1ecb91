#pragma once

#include <airlight/numeric.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// Light that comes to a point from all sides, as the air there scatters it: all that a view ray needs to
/// know of it. Everything is symmetric about the vertical plane through the sun.
///
/// Of molecules, which scatter by a polynomial of the second degree, four moments of the incoming light hold
/// all; they are written so that no azimuth is needed and a sun at the zenith is no special case. Of aerosol,
/// whose lobe is narrow, the scattered light itself is kept towards five sides.
template <typename T>
struct DiffuseLight {
    vec3<T> mean;        ///< [1/sr] mean radiance over all directions
    vec3<T> vertical;    ///< [1/sr] the mean times (3 z^2 - 1) / 2, z the cosine to the vertical
    vec3<T> slanted;     ///< [1/sr] the mean times x z / s, x the cosine to the sun's side, s the sun's sine
    vec3<T> across;      ///< [1/sr] the mean times (x^2 - y^2) / s^2
    vec3<T> aerosol_up;  ///< [1/sr] what aerosol scatters straight up: the mean times 4 pi phase
    vec3<T> aerosol_down;     ///< [1/sr] straight down
    vec3<T> aerosol_sunward;  ///< [1/sr] horizontally, to the side where the sun is
    vec3<T> aerosol_away;     ///< [1/sr] horizontally, away from the sun
    vec3<T> aerosol_aside;    ///< [1/sr] horizontally, across
};

/// Light that comes evenly from all sides, or is taken for such.
///
/// Units:    radiance and result [1/sr].
/// Domain:   radiance >= 0.
/// Accuracy: exact.
/// Errors:   none.
/// Source:   all phase functions have the mean 1 / (4 pi).
template <typename T>
DiffuseLight<T> even_light(const vec3<T>& radiance) {
    const vec3<T> none = vec3<T>(T(0), T(0), T(0));
    return DiffuseLight<T>{radiance, none, none, none, radiance, radiance, radiance, radiance, radiance};
}

/// Hook: light from all sides at an altitude where the cosine between the sun and the vertical is `mu_s`,
/// per unit of solar irradiance above the air.
struct NoDiffuseLight {
    template <typename T>
    DiffuseLight<T> operator()([[maybe_unused]] T altitude, [[maybe_unused]] T mu_s) const {
        return even_light(vec3<T>(T(0), T(0), T(0)));
    }
};

/// How fast aerosol's light goes over from the horizontal to straight up: the square of the cosine at which
/// it is halfway there, nearly [1].
template <typename T>
inline constexpr T aerosol_rise = T(0.12L);
/// The same straight down, where the dark ground comes close below the horizon [1].
template <typename T>
inline constexpr T aerosol_fall = T(0.04L);

/// The square of a sine below which a direction or a sun is too close to the vertical to have a side [1].
template <typename T>
inline constexpr T smallest_lean = T(1e-6L);

/// Light from all sides, scattered into one direction by a length of air.
///
///     sigma_R (mean + (P_2(z) vertical + 3 x z slanted + 3/4 (x^2 - y^2) across) / 2) + sigma_M aerosol
///
/// The first is exact for Rayleigh's phase function. Aerosol is interpolated: on the horizontal by the square
/// of the cosine to the sun's side, from there to the vertical by z^2 (1 + k) / (z^2 + k).
///
/// Units:    rayleigh and mie [1/L] scattered by the air there; mu and mu_s [1], cosines of the direction and
///           of the sun to the vertical; cos_theta [1] between direction and sun; result [1/(L sr)].
/// Shape:    rayleigh, mie and the result are spectra.
/// Domain:   cosines in [-1, 1] that belong to two unit vectors.
/// Accuracy: molecules to rounding; aerosol exact towards the five sides.
/// Errors:   none; never negative.
/// Source:   addition theorem of the Legendre polynomials; docs/theory/diffuse_light.md.
template <typename T>
[[gnu::always_inline]] inline vec3<T> scattered_diffuse_light(const DiffuseLight<T>& light,
                                                              const vec3<T>& rayleigh, const vec3<T>& mie,
                                                              T mu, T cos_theta, T mu_s) {
    // x s and (x^2 + y^2) s^2, so that nothing is divided by the sun's sine s.
    const T lean = cos_theta - mu * mu_s;
    const T level = glm::max((T(1) - mu * mu) * (T(1) - mu_s * mu_s), T(0));
    const vec3<T> bent = (T(0.75) * mu * mu - T(0.25)) * light.vertical +
                         (T(1.5) * mu * lean) * light.slanted +
                         (T(0.75) * lean * lean - T(0.375) * level) * light.across;
    const vec3<T> molecules = glm::max(light.mean + bent, vec3<T>(T(0), T(0), T(0)));

    const T blurred = level + smallest_lean<T>;
    const T sunward = glm::max(lean, T(0));
    const T away = glm::max(-lean, T(0));
    const T to_sun = sunward * sunward / blurred;
    const T from_sun = away * away / blurred;
    const vec3<T> horizontal = to_sun * light.aerosol_sunward + from_sun * light.aerosol_away +
                               glm::max(T(1) - to_sun - from_sun, T(0)) * light.aerosol_aside;

    const T above = glm::max(mu, T(0));
    const T below = glm::max(-mu, T(0));
    const T up = above * above * ((T(1) + aerosol_rise<T>) / (above * above + aerosol_rise<T>));
    const T down = below * below * ((T(1) + aerosol_fall<T>) / (below * below + aerosol_fall<T>));
    const vec3<T> aerosol =
        up * light.aerosol_up + down * light.aerosol_down + glm::max(T(1) - up - down, T(0)) * horizontal;
    return rayleigh * molecules + mie * aerosol;
}

}  // namespace airlight
