#pragma once

#include <airlight/constants.hpp>
#include <airlight/gauss.hpp>
#include <airlight/numeric.hpp>
#include <airlight/types.hpp>
#include <airlight/viewpoint.hpp>

namespace airlight {

/// Area of a segment of the unit circle over the cube of its half chord.
///
///     (acos(t) - t sqrt(1 - t^2)) / (1 - t^2)^(3/2)
///
/// It is pi / 2 for half a circle and 2 / 3 for a thin segment.
///
/// The quotient is smooth where the area itself starts as a power 3/2, and needs no inverse cosine.
///
/// Units:    chord_distance t of the chord from the centre, in radii [1]; result [1].
/// Domain:   chord_distance in [0, 1], clamped to it: the smaller of the two segments.
/// Accuracy: relative 1.5e-9 by the fit, the same in every precision, plus 8 roundoffs.
/// Errors:   none.
/// Source:   rational fit of degrees 3 and 3, tests/data/circle_segment_fit.py.
template <typename T>
T segment_over_chord(T chord_distance) {
    const T t = glm::clamp(chord_distance, T(0), T(1));
    const T p2 = T(0.33971378232939006244L) - t * T(0.000224972337249916872L);
    const T p = T(1.57079632679489661923L) + t * (T(1.54327287641581240984L) + t * p2);
    const T q2 = T(1.58833522982707963512L) + t * T(0.336284136845625142225L);
    const T q = T(1) + t * (T(2.25571765313156898462L) + t * q2);
    return p / q;
}

/// How one disc, the sun's, stands to another in front of it, a moon's or a planet's.
template <typename T>
struct Occultation {
    T gap;        ///< [1] from the edge in front to the centre behind, in radii of the disc behind
    T curvature;  ///< [1] radius of the disc behind over that of the one in front; 0 is a straight edge
};

/// What is left in sight of an evenly bright disc behind another.
///
/// Two discs share a lens, which is two segments of circles on one chord. Written with the gap instead of
/// the distance of the centres, nothing cancels when the disc in front is as large as a planet.
///
/// Units:    result [1], share of the disc's area.
/// Domain:   gap of any size: 1 and more is no overlap; curvature from 0 to infinity.
/// Accuracy: 8 roundoffs times the condition (measured: 5.3), and 3e-9 by segment_over_chord; exactly 1
///           without overlap, 0 behind a disc that covers it all; never grows as the gap shrinks, to
///           rounding.
/// Errors:   none; a disc in front that is smaller and wholly in front leaves a ring.
/// Source:   docs/theory/sun.md.
template <typename T>
T visible_share(const Occultation<T>& occultation) {
    const T gap = occultation.gap;
    const T curvature = occultation.curvature;
    if (gap >= T(1)) {
        return T(1);
    }
    // Inside the other disc altogether, or around it: then a ring is left.
    const T inverse = T(1) / glm::max(curvature, T(1));
    const T ring = (T(1) - inverse) * (T(1) + inverse);
    if (gap <= T(1) - T(2) * inverse) {
        return ring;
    }
    // The centres' distance in radii of the disc in front; the common chord's from the centre behind, in
    // radii of that; the square of its half length, by Heron's formula.
    const T reach = T(1) + curvature * gap;
    const T chord = (curvature + gap * (T(1) + reach)) / (T(2) * reach);
    const T wide = (T(2) + curvature * (gap + T(1))) / reach;
    const T narrow = (T(2) + curvature * (gap - T(1))) / reach;
    const T square = glm::clamp(T(0.25) * (T(1) - gap) * (T(1) + gap) * wide * narrow, T(0), T(1));
    const T cube = square * glm::sqrt(square);
    // And the chord's distance from the other centre, in that disc's radii.
    const T beyond = reach - curvature * chord;
    const T behind = cube * segment_over_chord(glm::abs(chord)) / pi<T>;
    const T in_front = curvature * cube * segment_over_chord(glm::abs(beyond)) / pi<T>;
    const T hidden = beyond < T(0) ? inverse * inverse + behind - in_front : behind + in_front;
    return glm::clamp(chord < T(0) ? behind - in_front : T(1) - hidden, ring, T(1));
}

/// What is left of the light of a disc that is darker towards its limb, behind another.
///
///     I = (1 - x^2)^(limb_exponent / 2),   x from the centre in radii
///
/// Such a disc is a stack of evenly bright ones of all sizes up to its own. Eight of them, at the points
/// of Gauss' rule, stand for all.
///
/// Units:    limb_exponent [1]; result [1], share of the disc's light.
/// Domain:   that of visible_share; limb_exponent from 0, an even disc, to 2.
/// Accuracy: 0.0025 of the disc's light (measured: 0.0023 beside a disc two thirds as wide, else 7e-4);
///           exact where visible_share is 1 or 0; never grows as the gap shrinks, to rounding.
/// Errors:   none; an exponent below 0 counts as 0.
/// Source:   docs/theory/sun.md.
template <typename T>
T visible_share_of_light(const Occultation<T>& occultation, T limb_exponent) {
    const T all = visible_share(occultation);
    if (all <= T(0) || all >= T(1)) {
        return all;
    }
    T seen = T(0);
    T whole = T(0);
    for (int i = 0; i < 8; ++i) {
        const T cut = limb_exponent > T(0) ? glm::pow(gauss_8_positions<T>[i], T(2) / limb_exponent) : T(0);
        const T area = T(1) - cut;
        const T radius = glm::sqrt(area);
        const Occultation<T> smaller =
            Occultation<T>{occultation.gap / radius, occultation.curvature * radius};
        whole += gauss_8_weights<T>[i] * area;
        seen += gauss_8_weights<T>[i] * area * visible_share(smaller);
    }
    return glm::min(seen / whole, T(1));
}

/// How a far small disc stands to the disc of a sphere.
///
/// Units:    cosines and sines of the angle between the centres and of the sphere's angular radius [1];
///           sin_radius of the far disc's angular radius [1].
/// Domain:   an eye outside the sphere: its angular radius is at most a quarter turn; sin_radius in [0,
///           1].
/// Accuracy: 4 roundoffs over sin_radius for the gap. The discs are taken for plane ones, which is off by
///           the square of sin_radius.
/// Errors:   none; no sphere (a sine of 0) hides nothing; a disc without size is seen or is not.
/// Source:   sine and cosine of a difference; docs/theory/sun.md.
template <typename T>
Occultation<T> occultation_of_disc(T cos_between, T sin_between, T cos_sphere, T sin_sphere, T sin_radius) {
    const T sine = sin_between * cos_sphere - cos_between * sin_sphere;
    const T cosine = cos_between * cos_sphere + sin_between * sin_sphere;
    // A quarter turn and more outside the edge; a quarter turn inside it, at the nadir of an eye on the
    // ground, the cosine is 0 too.
    if (sin_sphere <= T(0) || (cosine <= T(0) && sine >= T(0))) {
        return Occultation<T>{T(1), T(0)};
    }
    if (sin_radius <= T(0)) {
        return Occultation<T>{sine >= T(0) ? T(1) : T(-1), T(0)};
    }
    return Occultation<T>{sine / sin_radius, sin_radius * cos_sphere / sin_sphere};
}

/// How the sun's disc stands to the ground sphere, seen from an altitude: before sunrise and after
/// sunset.
///
/// Units:    ground_radius and altitude [L]; mu_s [1], cosine between the vertical and the sun's centre;
///           sin_radius [1] of the sun's angular radius.
/// Domain:   ground_radius > 0; altitude below the ground counts as 0; mu_s in [-1, 1]; sin_radius in [0,
///           1].
/// Accuracy: that of occultation_of_disc; light goes straight, without refraction.
/// Errors:   none.
/// Source:   occultation_of_disc.
template <typename T>
Occultation<T> occultation_by_ground(T ground_radius, T altitude, T mu_s, T sin_radius) {
    const T above = glm::max(altitude, T(0));
    const T radius = ground_radius + above;
    const T cos_sphere = glm::sqrt(above * (T(2) * ground_radius + above)) / radius;
    const T sin_between = safe_sqrt((T(1) - mu_s) * (T(1) + mu_s));
    return occultation_of_disc(-mu_s, sin_between, cos_sphere, ground_radius / radius, sin_radius);
}

/// How the sun's disc stands to a sphere, a moon for example.
///
/// Units:    centre of the sphere from the eye, and its radius [L]; to_sun a unit vector; sin_radius [1] of
///           the sun's angular radius.
/// Domain:   every centre whose square is finite; radius >= 0; sin_radius in [0, 1].
/// Accuracy: that of occultation_of_disc.
/// Errors:   none; inside the sphere it is dark.
/// Source:   occultation_of_disc.
template <typename T>
Occultation<T> occultation_by_sphere(const vec3<T>& centre, T radius, const vec3<T>& to_sun, T sin_radius) {
    const T distance = glm::sqrt(dot_product(centre, centre));
    if (distance <= radius) {
        return Occultation<T>{radius > T(0) ? T(-1) : T(1), T(0)};
    }
    const vec3<T> to_sphere = centre / distance;
    const vec3<T> across = cross_of_unit_vectors(to_sphere, to_sun);
    const T sin_sphere = radius / distance;
    const T cos_sphere = glm::sqrt((T(1) - sin_sphere) * (T(1) + sin_sphere));
    return occultation_of_disc(dot_product(to_sphere, to_sun), glm::sqrt(dot_product(across, across)),
                               cos_sphere, sin_sphere, sin_radius);
}

/// Share of sunlight that passes a sphere, a moon for example: a visibility for single_scattering.
///
/// In GLSL: #define AIRLIGHT_VISIBILITY(position) airlight_sunlight_past_sphere(centre - (position),
/// ...); in C++ PastSphere.
///
/// Units:    those of occultation_by_sphere; limb_exponent as in visible_share_of_light; result [1].
/// Domain:   that of occultation_by_sphere and visible_share_of_light.
/// Accuracy: that of occultation_by_sphere and visible_share_of_light.
/// Errors:   none.
/// Source:   docs/theory/sun.md.
template <typename T>
T sunlight_past_sphere(const vec3<T>& centre, T radius, const vec3<T>& to_sun, T sin_radius,
                       T limb_exponent) {
    const Occultation<T> occultation = occultation_by_sphere(centre, radius, to_sun, sin_radius);
    return visible_share_of_light(occultation, limb_exponent);
}

/// Share of sunlight that passes the ground sphere on its way to a sample of a view ray: a visibility
/// with the planet's penumbra, for scenes without Scene::planet_shadow, whose edge is sharp.
///
/// In GLSL: #define AIRLIGHT_VISIBILITY(position) airlight_sunlight_past_ground(radius, eye, position,
/// ...); in C++ PastGround.
///
/// Units:    ground_radius and position [L], position relative to the eye; to_sun a unit vector;
///           sin_radius and limb_exponent as in sunlight_past_sphere; result [1].
/// Domain:   ground_radius > 0; positions whose square is finite.
/// Accuracy: that of viewpoint_from_surface, occultation_by_ground and visible_share_of_light.
/// Errors:   none; a sample below the ground counts as on it.
/// Source:   docs/theory/sun.md.
template <typename T>
T sunlight_past_ground(T ground_radius, const Viewpoint<T>& eye, const vec3<T>& position,
                       const vec3<T>& to_sun, T sin_radius, T limb_exponent) {
    const Viewpoint<T> place =
        viewpoint_from_surface(ground_radius, position + eye.altitude * eye.up, eye.up);
    const T mu_s = glm::clamp(dot_product(place.up, to_sun), T(-1), T(1));
    const Occultation<T> occultation = occultation_by_ground(ground_radius, place.altitude, mu_s, sin_radius);
    return visible_share_of_light(occultation, limb_exponent);
}

/// AIRLIGHT_CPU_ONLY, in GLSL the macro calls sunlight_past_sphere. Hook: the share of sunlight that
/// passes a sphere on its way to `position` (relative to the eye), in [0, 1]. With it single_scattering
/// sees an eclipse.
template <typename T>
struct PastSphere {
    vec3<T> centre;   ///< [L] of the sphere, from the eye
    T radius;         ///< [L]
    vec3<T> to_sun;   ///< unit vector
    T sin_radius;     ///< [1] of the sun's angular radius
    T limb_exponent;  ///< [1] as in visible_share_of_light, 0 for an even sun

    T operator()(const vec3<T>& position) const {
        return sunlight_past_sphere(centre - position, radius, to_sun, sin_radius, limb_exponent);
    }
};

/// AIRLIGHT_CPU_ONLY, in GLSL the macro calls sunlight_past_ground. Hook: the share of sunlight that
/// passes the ground sphere on its way to `position` (relative to the eye), in [0, 1].
template <typename T>
struct PastGround {
    T ground_radius;   ///< [L]
    Viewpoint<T> eye;  ///< where positions count from
    vec3<T> to_sun;    ///< unit vector
    T sin_radius;      ///< [1] of the sun's angular radius
    T limb_exponent;   ///< [1] as in visible_share_of_light, 0 for an even sun

    T operator()(const vec3<T>& position) const {
        return sunlight_past_ground(ground_radius, eye, position, to_sun, sin_radius, limb_exponent);
    }
};

}  // namespace airlight
