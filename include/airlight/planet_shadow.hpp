#pragma once

#include <airlight/constants.hpp>
#include <airlight/view_path.hpp>

namespace airlight {

/// The sun as a straight line through the air sees it.
template <typename T>
struct SunOverLine {
    T cos_theta;       ///< [1] between the line and the direction to the sun
    T sin2_theta;      ///< [1] square of the sine of the same angle
    T perigee_height;  ///< [L] of the line's closest approach, from the centre towards the sun
};

/// The sun over a view ray.
///
/// The height over the terminator's plane at a distance s from the closest approach is
/// perigee_height + s cos_theta. Both sines come from cross products, which keep digits for far eyes
/// and for a sun straight ahead.
///
/// Units:    ground_radius [L]; direction and to_sun unit vectors.
/// Domain:   every viewpoint.
/// Accuracy: 4 roundoffs, of the eye's radius for perigee_height.
/// Errors:   none; an eye below the ground counts as standing on it.
/// Source:   docs/theory/altitude.md.
template <typename T>
SunOverLine<T> sun_over_line(T ground_radius, const Viewpoint<T>& eye, const vec3<T>& direction,
                             const vec3<T>& to_sun) {
    const vec3<T> across = glm::cross(direction, cross_of_unit_vectors(eye.up, direction));
    const vec3<T> between = cross_of_unit_vectors(direction, to_sun);
    return SunOverLine<T>{dot_product(direction, to_sun), dot_product(between, between),
                          (ground_radius + glm::max(eye.altitude, T(0))) * dot_product(across, to_sun)};
}

/// A stretch of a line, by distances from its closest approach to the centre.
template <typename T>
struct LineSpan {
    T begin;  ///< [L]
    T end;    ///< [L], equal to begin where the stretch is empty
};

/// The stretch of a line on which the sun's light has come below a shell around the planet: the
/// inside of the shell's shadow, a half cylinder. For altitude 0 it is the shadow of the planet.
///
///     |x|^2 - (x . s)^2 < (R + shell_altitude)^2   and   x . s < 0
///
/// Units:    ground_radius, perigee_altitude and shell_altitude [L].
/// Domain:   ground_radius > 0.
/// Accuracy: the exact answer for inputs moved by 8 roundoffs.
/// Errors:   none; no shadow gives an empty stretch at 0.
/// Source:   roots without cancellation as in intersect_ray_sphere.
template <typename T>
LineSpan<T> shadow_span(T ground_radius, T perigee_altitude, const SunOverLine<T>& sun, T shell_altitude) {
    const T half_linear = -sun.perigee_height * sun.cos_theta;
    const T constant =
        (perigee_altitude - shell_altitude) * (T(2) * ground_radius + perigee_altitude + shell_altitude) -
        sun.perigee_height * sun.perigee_height;
    if (sun.sin2_theta <= T(0)) {
        // Along the sunlight: inside from the terminator's plane on, for ever, or never.
        const T reach = constant < T(0) ? no_surface<T>() : T(0);
        return LineSpan<T>{sun.cos_theta < T(0) ? T(0) : -reach, sun.cos_theta < T(0) ? reach : T(0)};
    }
    const T discriminant = half_linear * half_linear - sun.sin2_theta * constant;
    if (discriminant <= T(0)) {
        return LineSpan<T>{T(0), T(0)};
    }
    const T root =
        half_linear > T(0) ? -half_linear - glm::sqrt(discriminant) : -half_linear + glm::sqrt(discriminant);
    const T other = root != T(0) ? constant / root : T(0);
    const T one = root / sun.sin2_theta;
    const T first = glm::min(one, other);
    const T last = glm::max(one, other);

    // Only behind the terminator's plane, which the line crosses at most once.
    const T crossing = sun.cos_theta != T(0) ? -sun.perigee_height / sun.cos_theta : T(0);
    const bool sunny = sun.cos_theta == T(0) && sun.perigee_height >= T(0);
    const T begin = sun.cos_theta < T(0) ? glm::max(first, crossing) : first;
    const T end = sun.cos_theta > T(0) ? glm::min(last, crossing) : last;
    const bool empty = sunny || begin >= end;
    return LineSpan<T>{empty ? T(0) : begin, empty ? T(0) : end};
}

}  // namespace airlight
