#pragma once

#include <airlight/numeric.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// Where an eye stands on or above the ground sphere.
template <typename T>
struct Viewpoint {
    T altitude;  ///< [L] above the ground sphere, negative below it
    vec3<T> up;  ///< unit vector away from the planet's centre
};

/// The viewpoint at a position measured from the planet's centre.
///
/// Good for eyes in space. Near the ground the position itself carries the error: a float
/// that holds 6371 km steps by half a metre; prefer viewpoint_from_surface there.
///
/// Units:    ground_radius and position in one length unit [L].
/// Domain:   ground_radius > 0; every position whose square is finite.
/// Accuracy: altitude to 2 roundoffs of the distance from the centre (measured: 1.7); up to 3
///           roundoffs (measured: 1.4).
/// Errors:   at the centre itself up is +z.
/// Source:   none.
template <typename T>
Viewpoint<T> viewpoint_from_centre(T ground_radius, const vec3<T>& position) {
    const T distance = glm::sqrt(dot_product(position, position));
    if (distance <= T(0)) {
        return Viewpoint<T>{-ground_radius, vec3<T>(T(0), T(0), T(1))};
    }
    return Viewpoint<T>{distance - ground_radius, position / distance};
}

/// The viewpoint at a position measured from a point on the ground sphere.
///
///     |centre to eye|^2 - R^2 = |p|^2 + 2 R (p . up_at_origin) = w
///     altitude = w / (R + |centre to eye|)
///
/// Keeps centimetres in float within hundreds of kilometres of the origin.
///
/// Units:    ground_radius and position in one length unit [L]; up_at_origin a unit vector.
/// Domain:   ground_radius > 0; every position whose square is finite.
/// Accuracy: altitude to 4 roundoffs of |p| + |p|^2 / 2R (measured: 1.6), plus the error of
///           up_at_origin's length times the height; up to 4 roundoffs (measured: 1.4). On Earth in
///           float 2e-5 m up to 100 m high and 10 km out, 0.002 m up to 10 km high and 100 km out.
/// Errors:   at the planet's centre up is up_at_origin.
/// Source:   difference of squares, worked out in docs/theory/altitude.md.
template <typename T>
Viewpoint<T> viewpoint_from_surface(T ground_radius, const vec3<T>& position, const vec3<T>& up_at_origin) {
    const vec3<T> from_centre = position + ground_radius * up_at_origin;
    const T distance = glm::sqrt(dot_product(from_centre, from_centre));
    if (distance <= T(0)) {
        return Viewpoint<T>{-ground_radius, up_at_origin};
    }

    // The difference distance - ground_radius would have lost the height's digits.
    const T height_over_origin = dot_product(position, up_at_origin);
    const T w = dot_product(position, position) + T(2) * ground_radius * height_over_origin;
    return Viewpoint<T>{w / (ground_radius + distance), from_centre / distance};
}

}  // namespace airlight
