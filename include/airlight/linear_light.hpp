#pragma once

#include <airlight/arc_tangent.hpp>
#include <airlight/numeric.hpp>

namespace airlight {

/// A strip of light: flat, straight and narrow, as bright from every direction on its one side.
template <typename T>
struct LinearLight {
    vec3<T> centre;    ///< [L]
    vec3<T> along;     ///< unit vector along the strip
    vec3<T> normal;    ///< unit vector across it, to the side that shines
    T half_length;     ///< [L]
    T width;           ///< [L] small beside the length
    vec3<T> radiance;  ///< of each of its points, the same in every direction of its side
};

/// A strip of light as one place sees it. Points of the strip are counted along its line, from the point of
/// the line that is nearest to the place.
template <typename T>
struct StripView {
    vec3<T> across;  ///< [L] from the place to the nearest point of the line
    vec3<T> along;   ///< unit vector along the line, to the strip's further end
    T distance;      ///< [L] to the line, at least a thousandth of the strip's width
    T begin;         ///< [L] where the strip begins; negative where it passes by the place
    T end;           ///< [L] where it ends
    T span;          ///< [1] difference of the sines of the angles to its ends
    T solid_angle;   ///< [sr] of the strip, from 0 to 2 pi; 0 from behind
};

/// Solid angle of a rectangle over one of its corners' feet, one side long and the other from b_0 to b_1.
///
///     atan(a b_1 / (z r_1)) - atan(a b_0 / (z r_0)),   r_i^2 = a^2 + b_i^2 + z^2
///
/// Units:    a, b_0, b_1 and height z [L]; result [sr].
/// Domain:   a >= 0; b_1 >= b_0; height > 0.
/// Accuracy: 16 roundoffs of |b| / (b_1 - b_0).
/// Errors:   none.
/// Source:   docs/theory/linear_light.md.
template <typename T>
T corner_solid_angle(T a, T b_0, T b_1, T height) {
    const T r_0 = glm::max(glm::sqrt(a * a + b_0 * b_0 + height * height), height);
    const T r_1 = glm::max(glm::sqrt(a * a + b_1 * b_1 + height * height), height);
    const T s_0 = b_0 / r_0;
    const T s_1 = b_1 / r_1;
    return arc_tangent(height * a * glm::max(s_1 - s_0, T(0)), height * height + a * a * (s_0 * s_1));
}

/// How a place sees a strip of light.
///
///     solid_angle = width height / distance^2 span
///
/// and within 32 widths, where its width and its corners show, that of the rectangle.
///
/// Units:    position [L].
/// Domain:   half_length and width >= 0; along and normal unit vectors at right angles.
/// Accuracy: solid angle 2e-4; in float 2e-5 more, and close past an end 8 roundoffs over the span.
/// Errors:   none; a strip without length or width has no solid angle, on the strip all is finite.
/// Source:   docs/theory/linear_light.md.
template <typename T>
StripView<T> strip_view(const LinearLight<T>& light, const vec3<T>& position) {
    const vec3<T> to_centre = light.centre - position;
    const T middle = dot_product(to_centre, light.along);
    const T side = middle < T(0) ? T(-1) : T(1);
    const vec3<T> across = to_centre - middle * light.along;
    const T distance2 = dot_product(across, across);
    const T distance = glm::max(glm::sqrt(distance2), T(0.001L) * light.width);
    const T begin = side * middle - light.half_length;
    const T end = side * middle + light.half_length;
    const T height = -dot_product(to_centre, light.normal);
    if (light.half_length <= T(0) || light.width <= T(0) || height <= T(0)) {
        return StripView<T>{across, side * light.along, distance, begin, end, T(0), T(0)};
    }
    const T near_reach = glm::max(glm::sqrt(begin * begin + distance * distance), distance);
    const T far_reach = glm::max(glm::sqrt(end * end + distance * distance), distance);
    // Sines of one sign are near each other far along the line: their difference without a subtraction.
    const T twice = (end - begin) * (end + begin);
    const T span = begin > T(0) ? (distance / near_reach) * (distance / far_reach) * twice /
                                      (end * near_reach + begin * far_reach)
                                : end / far_reach - begin / near_reach;
    const T half_width = T(0.5) * light.width;
    const T past = glm::max(begin, T(0));
    T solid_angle = span * (light.width / distance) * (height / distance);
    if (distance * distance + past * past < T(1024) * light.width * light.width) {
        const T aside = dot_product(glm::cross(light.normal, light.along), to_centre);
        const T b_0 = aside - half_width;
        const T b_1 = aside + half_width;
        const T far_part = corner_solid_angle(end, b_0, b_1, height);
        const T near_part = corner_solid_angle(glm::abs(begin), b_0, b_1, height);
        solid_angle = begin > T(0) ? glm::max(far_part - near_part, T(0)) : far_part + near_part;
    }
    return StripView<T>{across, side * light.along, distance, begin, end, span, solid_angle};
}

/// The point of a strip of light before which a share of its solid angle lies, from the place that sees it.
///
/// Units:    share [1]; result [L].
/// Domain:   view of strip_view; share in (0, 1).
/// Accuracy: 16 roundoffs of the distance.
/// Errors:   none.
/// Source:   docs/theory/linear_light.md.
template <typename T>
vec3<T> strip_point(const StripView<T>& view, T share) {
    const T d = view.distance;
    const T near_reach = glm::max(glm::sqrt(view.begin * view.begin + d * d), d);
    const T far_reach = glm::max(glm::sqrt(view.end * view.end + d * d), d);
    // What is missing from the sine to 1, and to 2 where it is negative: no digit is lost near the line.
    const T near_gap = view.begin > T(0) ? (d / near_reach) * (d / (near_reach + view.begin))
                                         : T(1) - view.begin / near_reach;
    const T far_gap = (d / far_reach) * (d / (far_reach + view.end));
    const T gap = near_gap + share * (far_gap - near_gap);
    const T cosine = safe_sqrt(gap * (T(2) - gap));
    const T at = cosine > T(0) ? d * ((T(1) - gap) / cosine) : view.end;
    return view.across + glm::clamp(at, view.begin, view.end) * view.along;
}

/// Direction to a corner of a strip of light, counted from its middle.
///
/// Units:    position and the result's divisor [L]; along and across -1 or 1; result a unit vector.
/// Domain:   width > 0.
/// Accuracy: 8 roundoffs of the way from the strip's centre over that from the corner.
/// Errors:   none; within a thousandth of the width from the corner it is shorter.
/// Source:   definition.
template <typename T>
vec3<T> strip_corner(const LinearLight<T>& light, const vec3<T>& position, T along, T across) {
    const vec3<T> to_corner = light.centre - position + (along * light.half_length) * light.along +
                              (across * T(0.5) * light.width) * glm::cross(light.normal, light.along);
    return to_corner / glm::max(glm::sqrt(dot_product(to_corner, to_corner)), T(0.001L) * light.width);
}

/// How near a place is to a strip of light: 1 within 4 widths, falling evenly to 0 at 8.
///
/// Units:    width [L]; result [1], in [0, 1].
/// Domain:   view of strip_view; width > 0.
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   where the points of strip_source no longer tell a strip from its line.
template <typename T>
T strip_nearness(const StripView<T>& view, T width) {
    const T past = glm::max(view.begin, T(0));
    const T reach = glm::sqrt(view.distance * view.distance + past * past);
    return glm::clamp(T(2) - reach / (T(4) * width), T(0), T(1));
}

/// The part of a strip of light that stands above a surface's own plane.
template <typename T>
struct StripPart {
    bool above;  ///< false when there is none; both ends are then where the strip begins
    T begin;     ///< [L] counted as in StripView
    T end;       ///< [L]
};

/// Which part of a strip of light stands above a surface's own plane.
///
/// Units:    normal a unit vector; result [L].
/// Domain:   view of strip_view.
/// Accuracy: 8 roundoffs of the way to the strip's further end, over the sine between strip and plane.
/// Errors:   none.
/// Source:   docs/theory/linear_light.md.
template <typename T>
StripPart<T> strip_part_above(const StripView<T>& view, const vec3<T>& normal) {
    const T across = dot_product(view.across, normal);
    const T along = dot_product(view.along, normal);
    const T near_rise = across + along * view.begin;
    const T far_rise = across + along * view.end;
    if (glm::max(near_rise, far_rise) <= T(0)) {
        return StripPart<T>{false, view.begin, view.begin};
    }
    const T extent = view.end - view.begin;
    const T begin =
        near_rise < T(0) ? view.begin + extent * (near_rise / (near_rise - far_rise)) : view.begin;
    const T end = far_rise < T(0) ? view.begin + extent * (near_rise / (near_rise - far_rise)) : view.end;
    return StripPart<T>{true, begin, end};
}

/// What one edge of a polygon of light adds to the irradiance of a surface, and where it crosses the plane
/// below which the surface sees nothing.
template <typename T>
struct LightEdge {
    T irradiance;    ///< [sr] of the part above the plane
    vec3<T> leaves;  ///< direction in which the edge goes below the plane, 0 where it does not
    vec3<T> enters;  ///< direction in which it comes up, 0 where it does not
};

/// Half the angle of an arc between two directions, times the cosine between its plane's normal and a
/// surface's.
///
///     angle (begin x end / |begin x end|) . normal / 2
///
/// Units:    begin and end directions of any length; normal a unit vector; result [sr].
/// Domain:   arcs shorter than half a circle.
/// Accuracy: 8 roundoffs, plus as many over the arc's sine.
/// Errors:   an arc without length, or half a circle long, gives 0.
/// Source:   docs/theory/linear_light.md.
template <typename T>
T arc_irradiance(const vec3<T>& begin, const vec3<T>& end, const vec3<T>& normal) {
    const vec3<T> turned = glm::cross(begin, end);
    const T sine = glm::sqrt(dot_product(turned, turned));
    if (sine <= T(0)) {
        return T(0);
    }
    return T(0.5) * arc_tangent(sine, dot_product(begin, end)) * (dot_product(turned, normal) / sine);
}

/// One edge of a polygon of light as a surface sees it.
///
/// Units:    begin and end directions, counted around the polygon; normal a unit vector.
/// Domain:   that of arc_irradiance.
/// Accuracy: that of arc_irradiance.
/// Errors:   those of arc_irradiance.
/// Source:   docs/theory/linear_light.md.
template <typename T>
LightEdge<T> light_edge(const vec3<T>& begin, const vec3<T>& end, const vec3<T>& normal) {
    const T begin_rise = dot_product(begin, normal);
    const T end_rise = dot_product(end, normal);
    LightEdge<T> edge = LightEdge<T>{T(0), vec3<T>(T(0), T(0), T(0)), vec3<T>(T(0), T(0), T(0))};
    if (begin_rise < T(0) && end_rise < T(0)) {
        return edge;
    }
    if (begin_rise < T(0)) {
        edge.enters = begin + (begin_rise / (begin_rise - end_rise)) * (end - begin);
        edge.irradiance = arc_irradiance(edge.enters, end, normal);
    } else if (end_rise < T(0)) {
        edge.leaves = begin + (begin_rise / (begin_rise - end_rise)) * (end - begin);
        edge.irradiance = arc_irradiance(begin, edge.leaves, normal);
    } else {
        edge.irradiance = arc_irradiance(begin, end, normal);
    }
    return edge;
}

/// Irradiance of a surface beside a strip of light of radiance 1: of the rectangle that it is, edge by edge,
/// above the surface's plane.
///
/// Units:    position [L]; normal a unit vector; result [sr].
/// Domain:   places before the strip, within 32 widths of it; width > 0.
/// Accuracy: 64 roundoffs, absolute.
/// Errors:   none; from 0 to pi.
/// Source:   Lambert's polygon, docs/theory/linear_light.md.
template <typename T>
T near_strip_irradiance(const LinearLight<T>& light, const vec3<T>& position, const vec3<T>& normal) {
    const vec3<T> a = strip_corner(light, position, T(-1), T(-1));
    const vec3<T> b = strip_corner(light, position, T(-1), T(1));
    const vec3<T> c = strip_corner(light, position, T(1), T(1));
    const vec3<T> d = strip_corner(light, position, T(1), T(-1));
    const LightEdge<T> ab = light_edge(a, b, normal);
    const LightEdge<T> bc = light_edge(b, c, normal);
    const LightEdge<T> cd = light_edge(c, d, normal);
    const LightEdge<T> da = light_edge(d, a, normal);
    // What the plane cuts off leaves an edge in the plane.
    const vec3<T> leaves = ab.leaves + bc.leaves + cd.leaves + da.leaves;
    const vec3<T> enters = ab.enters + bc.enters + cd.enters + da.enters;
    const T sum = ab.irradiance + bc.irradiance + cd.irradiance + da.irradiance +
                  arc_irradiance(leaves, enters, normal);
    return glm::clamp(sum, T(0), pi<T>);
}

/// Irradiance of a surface by a strip of light, without air: the integral of its radiance times the cosine to
/// the surface's normal, over the part that stands above the surface's own plane.
///
///     L angle / 2 (across . normal / d (b + sin b cos b) - along . normal cos^2 b), b from end to end
///
/// with solid_angle / span for the angle; within 8 widths more and more, within 4 alone, the rectangle's.
///
/// Units:    position [L]; normal a unit vector; result as radiance, times sr.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_view.
/// Accuracy: over the solid angle 1e-4 from 30 widths on, 0.1 % from 4, within them 4e-4.
/// Errors:   none; never above pi times the radiance.
/// Source:   docs/theory/linear_light.md.
template <typename T>
vec3<T> strip_irradiance(const LinearLight<T>& light, const vec3<T>& position, const vec3<T>& normal) {
    const StripView<T> view = strip_view(light, position);
    if (view.span <= T(0)) {
        return vec3<T>(T(0), T(0), T(0));
    }
    const T nearness = strip_nearness(view, light.width);
    const T near_part = nearness > T(0) ? nearness * near_strip_irradiance(light, position, normal) : T(0);
    const T d = view.distance;
    const T across = dot_product(view.across, normal);
    const T along = dot_product(view.along, normal);
    const StripPart<T> part = strip_part_above(view, normal);
    if (nearness >= T(1) || !part.above) {
        return near_part * light.radiance;
    }
    const T near_reach = glm::max(glm::sqrt(part.begin * part.begin + d * d), d);
    const T far_reach = glm::max(glm::sqrt(part.end * part.end + d * d), d);
    // Each over its reach, so that no product of four lengths can overflow.
    const T near_cosine = d / near_reach;
    const T far_cosine = d / far_reach;
    const T near_sine = part.begin / near_reach;
    const T far_sine = part.end / far_reach;
    const T turn = arc_tangent(near_cosine * far_sine - far_cosine * near_sine,
                               near_cosine * far_cosine + near_sine * far_sine);
    const T level = (across / d) * (turn + far_sine * far_cosine - near_sine * near_cosine);
    const T tilted = along * (far_sine * far_sine - near_sine * near_sine);
    const T line = glm::clamp(T(0.5) * (view.solid_angle / view.span) * (level + tilted), T(0), pi<T>);
    return (near_part + (T(1) - nearness) * line) * light.radiance;
}

}  // namespace airlight
