#pragma once

#include <airlight/occultation.hpp>
#include <airlight/phase.hpp>
#include <airlight/transmittance.hpp>

namespace airlight {

/// Sine of the sun's angular radius from the Earth's mean distance [1]: 695 700 km over 149 597 870.7 km.
/// In the year it swings by 1.7 % to both sides. From Mars it is 0.656 times as large.
template <typename T>
inline constexpr T solar_sin_radius = T(0.00465046726096215753156L);

/// The sun as a picture shows it.
template <typename T>
struct SunDisc {
    T sin_radius;            ///< [1] sine of its angular radius
    vec3<T> limb_exponents;  ///< [1] a of radiance (1 - x^2)^(a / 2) at x radii from the centre; 0 is even
    T sin_edge;              ///< [1] sine of half a pixel: the rim is spread by it to both sides; 0 is sharp
};

/// The sun from the Earth's mean distance, with a sharp rim.
///
/// Units:    those of SunDisc.
/// Domain:   none, it takes no argument.
/// Accuracy: the printed numbers, rounded to T. The exponents are those at 680, 550 and 440 nm.
/// Errors:   none.
/// Source:   Hestroffer and Magnan, Wavelength dependency of the solar limb darkening (1998), a law of
///           one parameter, with the exponents that renderers quote from its table 2; its straight line
///           0.292 um / wavelength - 0.023 is within 3 % of them.
template <typename T>
SunDisc<T> solar_disc() {
    return SunDisc<T>{solar_sin_radius<T>, vec3<T>(T(0.397L), T(0.503L), T(0.652L)), T(0)};
}

/// Solid angle of a disc in the sky.
///
///     2 pi (1 - cos) = 2 pi sin^2 / (1 + cos)
///
/// Units:    sin_radius [1], sine of the angular radius; result [sr].
/// Domain:   sin_radius in [0, 1]: up to half the sky.
/// Accuracy: 6 roundoffs times the condition (measured: 0.7), which near 1 the cosine's root makes large.
/// Errors:   none.
/// Source:   area of a cap of the unit sphere.
template <typename T>
T disc_solid_angle(T sin_radius) {
    const T cosine = safe_sqrt((T(1) - sin_radius) * (T(1) + sin_radius));
    return T(2) * pi<T> * (sin_radius * sin_radius / (T(1) + cosine));
}

/// Mean radiance of a disc that gives a surface facing it unit irradiance.
///
///     1 / (pi sin^2)
///
/// The mean is over the disc as that surface sees it, so the cosine is counted and nothing is
/// approximate.
///
/// Units:    sin_radius [1]; result [1/sr] per unit of irradiance.
/// Domain:   sin_radius in (0, 1].
/// Accuracy: 3 ulp.
/// Errors:   sin_radius 0 divides by zero.
/// Source:   integral of the cosine over the disc.
template <typename T>
T disc_radiance(T sin_radius) {
    return T(1) / (pi<T> * sin_radius * sin_radius);
}

/// Mean of a power over a window, of which only what lies above 0 counts.
///
///     1 / (2 w) integral_(x - w)^(x + w) max(s, 0)^power ds
///
/// Units:    x, half_width w and power [1]; result [1].
/// Domain:   x at most 1e6; half_width from 0 to 1e6; power from 0 to 3.
/// Accuracy: 64 roundoffs of (x + w)^power where the window is wide; relative 1e-9 by the series where w
///           is below x / 32.
/// Errors:   none; a window below 0 gives 0.
/// Source:   the power's integral, and its Taylor series where that would cancel.
template <typename T>
T windowed_power(T x, T half_width, T power) {
    if (x + half_width <= T(0)) {
        return T(0);
    }
    if (half_width < T(0.03125) * x) {
        const T square = (half_width / x) * (half_width / x);
        const T second = power * (power - T(1)) / T(6);
        const T fourth = second * (power - T(2)) * (power - T(3)) / T(20);
        return glm::pow(x, power) * (T(1) + square * (second + square * fourth));
    }
    const T above = glm::pow(x + half_width, power + T(1));
    const T below = glm::pow(glm::max(x - half_width, T(0)), power + T(1));
    return (above - below) / (T(2) * half_width * (power + T(1)));
}

/// Radiance of a limb-darkened disc over its mean.
///
///     (1 + a / 2) (1 - q)^(a / 2),   q = (distance from the centre / radius)^2
///
/// A spread rim is a mean over a window in q. Such windows keep the disc's light exactly, whatever their
/// width, because equal steps of q are equal areas.
///
/// Units:    square q, exponent a and spread, the window's half width in q [1]; result [1].
/// Domain:   square >= 0; exponent from 0 to 2; spread from 0 to 1e6.
/// Accuracy: 4 roundoffs times (1 + value) (1 + 1 / max(|1 - q|, spread)) (measured: 1.1), and 1e-9 by
///           the series of windowed_power.
/// Errors:   none; 0 outside the disc and its rim.
/// Source:   Hestroffer and Magnan, Wavelength dependency of the solar limb darkening (1998); the window:
///           docs/theory/sun.md.
template <typename T>
T limb_darkening(T square, T exponent, T spread) {
    const T power = T(0.5) * exponent;
    return (T(1) + power) * windowed_power(T(1) - square, spread, power) /
           windowed_power(T(1), spread, power + T(1));
}

/// Radiance of the sun's disc in a direction, before the air. Multiply by transmittance_to_space.
///
/// All of the disc's light together gives a surface that faces the sun unit irradiance, also where the
/// rim is spread.
///
/// Units:    direction and to_sun unit vectors; result [1/sr] per unit of solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   disc.sin_radius in (0, 1]; disc.sin_edge from 0 to 1 and to a thousand sin_radius.
/// Accuracy: that of limb_darkening; the angle from the centre to 4 roundoffs.
/// Errors:   none; 0 outside the disc. A sin_radius of 0 divides by zero.
/// Source:   docs/theory/sun.md.
template <typename T>
vec3<T> sun_radiance(const SunDisc<T>& disc, const vec3<T>& direction, const vec3<T>& to_sun) {
    const vec3<T> across = cross_of_unit_vectors(direction, to_sun);
    const T square = dot_product(across, across) / (disc.sin_radius * disc.sin_radius);
    const T edge = disc.sin_edge / disc.sin_radius;
    const T spread = edge * (T(2) + edge);
    if (dot_product(direction, to_sun) <= T(0) || square >= T(1) + spread) {
        return vec3<T>(T(0), T(0), T(0));
    }
    const vec3<T> a = disc.limb_exponents;
    return disc_radiance(disc.sin_radius) * vec3<T>(limb_darkening(square, a.x, spread),
                                                    limb_darkening(square, a.y, spread),
                                                    limb_darkening(square, a.z, spread));
}

/// Height of the middle of what a straight horizon leaves of an even disc, over the disc's centre.
///
///     2 (1 - gap^2)^(3/2) / (3 area in sight)
///
/// Units:    gap [1], the centre's height over the horizon in radii; result [1] in radii.
/// Domain:   every gap; clamped to [-1, 1].
/// Accuracy: that of segment_over_chord.
/// Errors:   none; 1 for the last of the disc, 0 above the horizon.
/// Source:   centroid of a segment of a circle.
template <typename T>
T visible_middle(T gap) {
    const T chord = glm::clamp(gap, T(-1), T(1));
    const T shape = segment_over_chord(glm::abs(chord));
    if (chord < T(0)) {
        return T(2) / (T(3) * shape);
    }
    const T square = (T(1) - chord) * (T(1) + chord);
    const T cube = square * glm::sqrt(square);
    return T(2) * cube / (T(3) * (pi<T> - cube * shape));
}

/// Sunlight that arrives at a point from a sun of finite size, on a surface that faces it.
///
/// The light of what the horizon leaves of the disc, dimmed as it is at the middle of that: dusk is as
/// long as the sun needs to set, and has no step.
///
/// Units:    altitude [L]; mu_s [1], cosine between the vertical and the sun's centre; sin_radius [1];
///           result [1], share of the solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   that of optical_depth; sin_radius in [0, 1], 0 gives transmittance_to_space.
/// Accuracy: 0.0015 of full sunlight in the air, 0.11 from orbit, where the disc is taller than the air
///           (measured against the mean over the disc: 0.0011 and 0.099); light goes straight, without
///           refraction.
/// Errors:   none; without Scene::planet_shadow the ground is ignored.
/// Source:   occultation_by_ground, transmittance.
template <typename T, typename Scene = DefaultScene>
vec3<T> sunlight(const Atmosphere<T>& atmosphere, T altitude, T mu_s, T sin_radius) {
    T share = T(1);
    T mu = mu_s;
    if constexpr (Scene::planet_shadow) {
        const Occultation<T> ground =
            occultation_by_ground(atmosphere.ground_radius, altitude, mu_s, sin_radius);
        share = visible_share(ground);
        if (share <= T(0)) {
            return vec3<T>(T(0), T(0), T(0));
        }
        const T sine = safe_sqrt((T(1) - mu_s) * (T(1) + mu_s));
        mu = glm::min(mu_s + sin_radius * sine * visible_middle(ground.gap), T(1));
    }
    return share * transmittance<T, Scene>(atmosphere, altitude, mu, no_surface<T>());
}

/// Parameter of the lobe that draws the sun in the notes on precomputed scattering after Elek [1].
template <typename T>
inline constexpr T elek_sun_g = T(0.99L);

/// What those notes multiply the lobe by [1].
template <typename T>
inline constexpr T elek_sun_scale = T(0.003L);

/// The lobe that draws the sun in the notes on precomputed scattering after Elek, before their scale.
///
///     (1 - g)^2 / (4 pi (1 + g^2 - 2 g cos_theta)^(3/2))
///
/// It is no phase function: with 1 - g^2 in place of (1 - g)^2 it would be Henyey and Greenstein's. Over
/// the sphere it comes to (1 - g) / (1 + g), 0.005025 for g = 0.99. For a sun of the right light use
/// sun_radiance; for that picture elek_sun_scale times this.
///
/// Units:    cos_theta and g [1]; result [1/sr].
/// Domain:   cos_theta in [-1, 1], 1 is the sun's centre; g in (-1, 1), elek_sun_g.
/// Accuracy: 8 roundoffs times the condition (measured: 1.8).
/// Errors:   g = 1 or -1 gives 0 off the peak and divides zero by zero in it.
/// Source:   Notes on precomputed atmospheric scattering in Unity, sun simulation.
template <typename T>
T elek_sun_lobe(T cos_theta, T g) {
    const T d = henyey_greenstein_denominator(cos_theta, g);
    return (T(1) - g) * (T(1) - g) / (T(4) * pi<T> * d * glm::sqrt(d));
}

/// The sun of Leenman's shader: 3 where the cosine to its centre is above 0.9998, else 0. A disc 4.3
/// times as wide as the sun's.
///
/// Units:    cos_theta [1]; result in the unit of that shader's scene colour, its sun's strength being
///           40.
/// Domain:   cos_theta in [-1, 1].
/// Accuracy: exact for inputs moved by 1 roundoff.
/// Errors:   none; NaN gives 0.
/// Source:   Leenman, Atmospheric scattering explained (2021), the sun of the scene.
template <typename T>
T leenman_sun(T cos_theta) {
    return cos_theta > T(0.9998L) ? T(3) : T(0);
}

}  // namespace airlight
