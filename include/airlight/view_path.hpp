#pragma once

#include <airlight/atmosphere.hpp>
#include <airlight/numeric.hpp>
#include <airlight/types.hpp>
#include <airlight/viewpoint.hpp>

namespace airlight {

/// Where a view ray is inside the air, and whether it ends on the ground sphere.
template <typename T>
struct ViewPath {
    bool in_air;          ///< false when no part of the ray is inside the air; begin and end are then 0
    T begin;              ///< [L] distance from the eye to the first air
    T end;                ///< [L] distance from the eye to the last air, or to the surface
    bool reaches_ground;  ///< true when the ground sphere stops the ray before `distance`
};

/// The stretch of a view ray inside the air, measured from where it starts: at the eye, or where
/// the ray enters the air. Distances from there keep digits that distances from a far eye lose.
template <typename T>
struct AirRay {
    bool in_air;          ///< false when no part of the ray is inside the air
    bool reaches_ground;  ///< true when the ground sphere stops the ray
    T begin;              ///< [L] from the eye to the start of the stretch
    T extent;             ///< [L] length of the stretch
    T altitude;           ///< [L] of its start, in [0, top_altitude]
    T along;              ///< [L] its start's position along the ray, from the closest approach to the centre
    T perigee_radius;     ///< [L] of the line's closest approach to the centre, wherever on the line it is
    T perigee_altitude;   ///< [L] the same, above the ground sphere
};

/// Altitude after a distance along a ray that starts at `altitude`.
///
///     w = r^2 - R^2 = altitude (2 R + altitude) + distance (2 along + distance)
///     result = w / (R + sqrt(R^2 + w))
///
/// No difference of radii is ever formed, so the result is good to centimetres on Earth.
///
/// Units:    all in one length unit [L]; along = (ground_radius + altitude) mu.
/// Domain:   ground_radius > 0; altitude >= -ground_radius; any distance whose square is finite.
/// Accuracy: 3 roundoffs of (distance |2 along + distance| + altitude (2 R + altitude)) / 2R; on
///           Earth in float 0.002 m up to 10 km high.
/// Errors:   none; where rounding puts the point past the centre it counts as the centre.
/// Source:   difference of squares, worked out in docs/theory/altitude.md.
template <typename T>
T altitude_along_ray(T ground_radius, T altitude, T along, T distance) {
    const T w = altitude * (T(2) * ground_radius + altitude) + distance * (T(2) * along + distance);
    return w / (ground_radius + safe_sqrt(ground_radius * ground_radius + w));
}

/// The stretch of a view ray inside the air, in coordinates that keep digits.
///
/// An eye below the ground sphere counts as standing on it. The sine of the view angle comes from
/// the cross product: for far eyes the cosine has no digits left for it.
///
/// Units:    lengths in the atmosphere's unit [L]; direction a unit vector.
/// Domain:   every viewpoint up to 1e12 m from an Earth; distance >= 0, no_surface() for none.
/// Accuracy: in float no wrong decision (in the air, reaches the ground) for eyes from 1 m to 1e8 m,
///           other than those that rounding the inputs could flip (measured: 0 of 1.69e6).
/// Errors:   a tangent ray misses the air and misses the ground.
/// Source:   docs/theory/altitude.md; roots without cancellation as in intersect_ray_sphere.
template <typename T>
AirRay<T> air_ray(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                  T distance) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    const T eye_altitude = glm::max(eye.altitude, T(0));
    const T mu = dot_product(eye.up, direction);
    const vec3<T> across = cross_of_unit_vectors(eye.up, direction);
    const T sine = glm::sqrt(dot_product(across, across));

    // Perigee is the ray's closest approach to the centre. Its depth below the ground is written
    // so that a low, nearly horizontal ray subtracts two small numbers, not two radii.
    const T perigee_radius = (radius + eye_altitude) * sine;
    const T perigee_depth = radius * (mu * mu / (T(1) + sine)) - eye_altitude * sine;
    const T half_chord = safe_sqrt((top + perigee_depth) * (radius + top + perigee_radius));
    const T eye_along = (radius + eye_altitude) * mu;

    // From the eye, or from the entry into the air if the eye is outside.
    const T above_top = (eye_altitude - top) * (T(2) * radius + top + eye_altitude);
    const bool outside = eye_altitude > top;
    const bool in_front = half_chord > T(0) && eye_along < T(0);
    if (outside && !in_front) {
        return AirRay<T>{false, false, T(0), T(0), T(0), T(0), perigee_radius, -perigee_depth};
    }
    const T begin = outside ? above_top / (half_chord - eye_along) : T(0);
    const T altitude = outside ? top : eye_altitude;
    const T along = outside ? -half_chord : eye_along;

    // The ray leaves the air at its top, on the ground, or at the surface it ends on.
    const T exit_length = along > T(0) ? -above_top / (along + half_chord) : half_chord - along;
    const T ground_discriminant = perigee_depth * (radius + perigee_radius);
    const bool meets_ground = ground_discriminant > T(0) && along < T(0);
    const T ground_product = altitude * (T(2) * radius + altitude);
    const T ground_length =
        meets_ground ? ground_product / (safe_sqrt(ground_discriminant) - along) : exit_length;
    const T surface_length = distance - begin;
    const T length = glm::max(glm::min(glm::min(exit_length, ground_length), surface_length), T(0));
    return AirRay<T>{length > T(0),  meets_ground && ground_length <= surface_length,
                     begin,          length,
                     altitude,       along,
                     perigee_radius, -perigee_depth};
}

/// Where a view ray is inside the air, and whether the ground sphere ends it.
///
/// One call for the four cases: eye inside or outside the air, surface inside or outside.
///
/// Units:    lengths in the atmosphere's unit [L]; direction a unit vector.
/// Domain:   every viewpoint up to 1e12 m from an Earth; distance >= 0, no_surface() for none.
/// Accuracy: that of air_ray; begin and end to 4 roundoffs times condition (measured: 1.3).
/// Errors:   an eye below the ground counts as standing on it; a tangent ray misses.
/// Source:   docs/theory/altitude.md.
template <typename T>
ViewPath<T> view_path(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                      T distance) {
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, distance);
    if (!ray.in_air) {
        return ViewPath<T>{false, T(0), T(0), ray.reaches_ground};
    }
    return ViewPath<T>{true, ray.begin, ray.begin + ray.extent, ray.reaches_ground};
}

}  // namespace airlight
