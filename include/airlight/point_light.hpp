#pragma once

#include <airlight/arc_tangent.hpp>
#include <airlight/strip_scattering.hpp>

namespace airlight {

/// A small light: a point that shines to all sides, or a spot that shines within a cone.
template <typename T>
struct PointLight {
    vec3<T> position;   ///< [L]
    vec3<T> intensity;  ///< [1/sr] of radiance times L^2: irradiance at a distance d is intensity / d^2
    vec3<T> axis;       ///< unit vector, where a spot shines; any for a point
    T cos_inner;        ///< [1] within this angle of the axis a spot has all its intensity
    T cos_outer;        ///< [1] beyond this one none; -2 makes a point of it
};

/// Share of its intensity that a light sends in a direction: a cubic between the two cones of a spot.
///
/// Units:    direction a unit vector, from the light; result [1], in [0, 1].
/// Domain:   cos_inner >= cos_outer.
/// Accuracy: 8 roundoffs over the difference of the two cosines.
/// Errors:   two cones that are one make a hard edge; no cosine is below -2, a point's outer one.
/// Source:   Hermite's cubic with level ends.
template <typename T>
T spot_share(const PointLight<T>& light, const vec3<T>& direction) {
    const T cosine = dot_product(light.axis, direction);
    const T range = light.cos_inner - light.cos_outer;
    if (light.cos_outer < T(-1) || cosine >= light.cos_inner) {
        return T(1);
    }
    const T x = range > T(0) ? glm::clamp((cosine - light.cos_outer) / range, T(0), T(1)) : T(0);
    return x * x * (T(3) - T(2) * x);
}

/// Light of a point or a spot that air at a place turns into a view ray, per unit of way, times the square of
/// the distance from the light: finite on the light too.
///
///     density (rayleigh_scattering p_R + mie_scattering p_M) intensity t V
///
/// Units:    position [L]; direction a unit vector, away from the eye; result as radiance times L.
/// Shape:    the result is a spectrum.
/// Domain:   that of habitat_column.
/// Accuracy: that of habitat_transmittance and of the phase functions.
/// Errors:   none; on the light it counts as shining across the ray.
/// Source:   definition.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> point_source(const HabitatAir<T>& air, const PointLight<T>& light, const vec3<T>& position,
                     const vec3<T>& direction, const LightVisibility& light_visibility = LightVisibility{}) {
    const vec3<T> way = position - light.position;
    const T distance = glm::sqrt(dot_product(way, way));
    vec3<T> from_light = light.axis;
    T cos_theta = T(0);
    if (distance > T(0)) {
        from_light = way / distance;
        cos_theta = glm::clamp(-dot_product(from_light, direction), T(-1), T(1));
    }
    const T density = habitat_density(air, position);
    const T share = spot_share(light, from_light) * light_visibility(light.position, position);
    return share * light.intensity * habitat_transmittance<T, Scene>(air, light.position, position) *
           habitat_scattering<T, Scene>(air, density, cos_theta);
}

/// Light of a point or a spot that the air between the eye and a surface scatters towards the eye, once
/// scattered: in a habitat, or in the even fog that air without density_rise is.
///
///     integral_0^distance t(eye, q) point_source(q) / |q - light|^2 dq
///
/// Seen from the light the ray's places are counted by their angle: there the one over the square of the
/// distance is even, and the rest is smooth for the Scene::nodes points of Gauss and Legendre.
///
/// Units:    eye [L]; direction a unit vector; distance [L]; result as radiance.
/// Shape:    the result is a spectrum.
/// Domain:   that of point_source; distance finite.
/// Accuracy: 8 nodes 0.1 % for 95 % of rays through fog of depths to 3, 0.2 % at most; in thin fog 2e-8.
/// Errors:   none; a ray that meets the light passes it at a ten-thousandth of its length.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> point_scattering(const HabitatAir<T>& air, const PointLight<T>& light, const vec3<T>& eye,
                         const vec3<T>& direction, T distance,
                         const LightVisibility& light_visibility = LightVisibility{}) {
    vec3<T> sum = vec3<T>(T(0), T(0), T(0));
    if (distance <= T(0)) {
        return sum;
    }
    const vec3<T> to_light = light.position - eye;
    const T foot = dot_product(to_light, direction);
    const vec3<T> across = to_light - foot * direction;
    const T gap = glm::max(glm::sqrt(dot_product(across, across)), T(1e-4L) * distance);
    const T turn = arc_tangent(gap * distance, gap * gap + foot * (foot - distance));
    for (int i = 0; i < Scene::nodes; ++i) {
        // A quarter of the angle from the eye to the node, as the light sees them, doubled twice.
        const vec2<T> quarter = direction_at_angle(T(0.25) * turn * gauss_position<T, Scene>(i));
        const T half_cosine = (quarter.x - quarter.y) * (quarter.x + quarter.y);
        const T half_sine = T(2) * quarter.x * quarter.y;
        const T cosine = (half_cosine - half_sine) * (half_cosine + half_sine);
        const T sine = T(2) * half_cosine * half_sine;
        // By the law of sines in the triangle of light, eye and node.
        const T along = (gap * gap + foot * foot) * sine;
        const T t = along / glm::max(gap * cosine + foot * sine, T(1e-6L) * along / distance);
        const vec3<T> position = eye + glm::clamp(t, T(0), distance) * direction;
        sum += gauss_weight<T, Scene>(i) * habitat_transmittance<T, Scene>(air, eye, position) *
               point_source<T, Scene>(air, light, position, direction, light_visibility);
    }
    return sum * (turn / gap);
}

}  // namespace airlight
