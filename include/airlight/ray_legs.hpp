#pragma once

#include <airlight/single_scattering.hpp>

namespace airlight {

/// The least optical depth for which the difference of two columns outwards has digits left [1].
template <typename T>
inline constexpr T thin_depth = T(1e-3L);

/// The two legs of a ray, down to its closest approach to the centre and up from there.
template <typename T>
struct RayLegs {
    T turn;              ///< [L] from the start to where the legs meet
    RayPoint<T> start;   ///< where the ray starts
    RayPoint<T> turned;  ///< its closest approach, or the end that is nearest to it
    RayPoint<T> last;    ///< where it ends
};

/// The legs of a ray.
///
/// Units:    lengths in the atmosphere's unit [L].
/// Domain:   a ray in the air.
/// Accuracy: that of ray_point.
/// Errors:   none; a leg that the ray does not have is empty.
/// Source:   ray_point.
template <typename T, typename Scene = DefaultScene>
RayLegs<T> ray_legs(const Atmosphere<T>& atmosphere, const LitRay<T>& ray) {
    const T turn = glm::clamp(-ray.air.along, T(0), ray.air.extent);
    const RayPoint<T> turned = ray_point<T, Scene>(atmosphere, ray, turn);
    RayPoint<T> start = turned;
    RayPoint<T> last = turned;
    if (ray.air.along < T(0)) {
        start = ray_point<T, Scene>(atmosphere, ray, T(0));
    }
    if (ray.air.along + ray.air.extent > T(0)) {
        last = ray_point<T, Scene>(atmosphere, ray, ray.air.extent);
    }
    return RayLegs<T>{turn, start, turned, last};
}

/// What the air between a ray's start and a point of a leg is counted from: it is this less the point's air
/// outwards where the leg climbs, and plus it where the leg falls.
///
/// Units:    result [L].
/// Domain:   legs of ray_legs.
/// Accuracy: 3 roundoffs of the largest column.
/// Errors:   none.
/// Source:   column_outwards.
template <typename T>
Column<T> leg_offset(const RayLegs<T>& legs, bool climbs) {
    const Column<T> down = column_sum(Column<T>{T(0), T(0), T(0)}, T(-1), legs.start.outwards);
    return column_sum(down, climbs ? T(2) : T(0), legs.turned.outwards);
}

/// The optical depth of a whole ray.
///
/// Units:    result [1].
/// Shape:    the result is a spectrum.
/// Domain:   legs of ray_legs.
/// Accuracy: that of column_outwards.
/// Errors:   none; rounding below 0 counts as 0.
/// Source:   leg_offset.
template <typename T, typename Scene = DefaultScene>
vec3<T> depth_of_legs(const Atmosphere<T>& atmosphere, const RayLegs<T>& legs) {
    const Column<T> passed = column_sum(leg_offset(legs, true), T(-1), legs.last.outwards);
    return glm::max(column_optical_depth<T, Scene>(atmosphere, passed), vec3<T>(T(0), T(0), T(0)));
}

/// What a ray loses over what its nodes found of that. Light from all sides that the nodes found, times this,
/// is right in even light, however thick the air is, and makes no light.
///
///     (1 - exp(-depth)) / found
///
/// Of a ray thinner than thin_depth the nodes' depth is taken: a difference of columns has no digits for it.
///
/// Units:    found, swept and depth [1]: what the nodes found of the loss, the optical depth by the nodes,
///           and that in closed form; result [1].
/// Domain:   all >= 0.
/// Accuracy: that of one_minus_exp.
/// Errors:   none; where there was nothing to find and nothing found, 1.
/// Source:   conservation of energy.
template <typename T>
T loss_ratio(T found, T swept, T depth) {
    const T thin = thin_depth<T>;
    const T closed = glm::clamp(T(2) * depth / thin - T(1), T(0), T(1));
    const T known = (T(1) - closed) * glm::min(swept, thin) + closed * depth;
    return (one_minus_exp(known) + smallest_share<T>) / (found + smallest_share<T>);
}

/// loss_ratio of each channel.
///
/// Units:    those of loss_ratio.
/// Shape:    found, swept, depth and the result are spectra.
/// Domain:   that of loss_ratio.
/// Accuracy: that of loss_ratio.
/// Errors:   none.
/// Source:   conservation of energy.
template <typename T>
vec3<T> loss_ratios(const vec3<T>& found, const vec3<T>& swept, const vec3<T>& depth) {
    return vec3<T>(loss_ratio(found.x, swept.x, depth.x), loss_ratio(found.y, swept.y, depth.y),
                   loss_ratio(found.z, swept.z, depth.z));
}

/// The node map of one leg: the nodes of single_scattering, drawn to the eye but not to the sun, for light
/// that comes from everywhere.
///
/// Units:    lengths in the atmosphere's unit [L].
/// Domain:   legs of ray_legs; a leg that the ray has.
/// Accuracy: none, every map is exact.
/// Errors:   none.
/// Source:   docs/theory/nodes.md.
template <typename T, typename Scene = DefaultScene>
NodeMap<T> leg_map(const Atmosphere<T>& atmosphere, const LitRay<T>& ray, const RayLegs<T>& legs,
                   bool climbs) {
    RayPoint<T> high = legs.start;
    if (climbs) {
        high = legs.last;
    }
    const T length = climbs ? ray.air.extent - legs.turn : legs.turn;
    const T low_along = glm::abs(ray.air.along + legs.turn);
    const T low_radius = atmosphere.ground_radius + legs.turned.altitude;
    const T high_radius = atmosphere.ground_radius + high.altitude;
    const T rise = length * (T(2) * low_along + length) / (low_radius + high_radius);
    const T height = glm::max(ray.layers.rayleigh_height, T(1e-6L) * rise);
    const T depth =
        guiding_depth<T, Scene>(atmosphere, column_sum(legs.turned.outwards, T(-1), high.outwards));
    const NodeFit<T> fit = node_fit<T, Scene>();
    const T pull = climbs ? -fit.view * depth : fit.view * depth;
    return node_map(fit, low_radius, low_along, high_radius, rise, height, pull);
}

}  // namespace airlight
