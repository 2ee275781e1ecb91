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

/// Irradiance of a surface by a strip of light, without air: the integral of its radiance times the cosine to
/// the surface's normal, over the part that stands above the surface's own plane.
///
///     L angle / 2 (across . normal / d (b + sin b cos b) - along . normal cos^2 b), b from end to end
///
/// with solid_angle / span for the angle.
///
/// Units:    position [L]; normal a unit vector; result as radiance, times sr.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_view.
/// Accuracy: over the solid angle 1e-4 from 30 widths on, 0.3 % from 4; closer, beside a strip's edge, 0.4.
/// Errors:   none; never above pi times the radiance.
/// Source:   docs/theory/linear_light.md.
template <typename T>
vec3<T> strip_irradiance(const LinearLight<T>& light, const vec3<T>& position, const vec3<T>& normal) {
    const StripView<T> view = strip_view(light, position);
    if (view.span <= T(0)) {
        return vec3<T>(T(0), T(0), T(0));
    }
    const T d = view.distance;
    const T across = dot_product(view.across, normal);
    const T along = dot_product(view.along, normal);
    const T near_rise = across + along * view.begin;
    const T far_rise = across + along * view.end;
    if (glm::max(near_rise, far_rise) <= T(0)) {
        return vec3<T>(T(0), T(0), T(0));
    }
    const T extent = view.end - view.begin;
    const T begin =
        near_rise < T(0) ? view.begin + extent * (near_rise / (near_rise - far_rise)) : view.begin;
    const T end = far_rise < T(0) ? view.begin + extent * (near_rise / (near_rise - far_rise)) : view.end;
    const T near_reach = glm::max(glm::sqrt(begin * begin + d * d), d);
    const T far_reach = glm::max(glm::sqrt(end * end + d * d), d);
    // Each over its reach, so that no product of four lengths can overflow.
    const T near_cosine = d / near_reach;
    const T far_cosine = d / far_reach;
    const T near_sine = begin / near_reach;
    const T far_sine = end / far_reach;
    const T turn = arc_tangent(near_cosine * far_sine - far_cosine * near_sine,
                               near_cosine * far_cosine + near_sine * far_sine);
    const T level = (across / d) * (turn + far_sine * far_cosine - near_sine * near_cosine);
    const T tilted = along * (far_sine * far_sine - near_sine * near_sine);
    return light.radiance *
           glm::clamp(T(0.5) * (view.solid_angle / view.span) * (level + tilted), T(0), pi<T>);
}

}  // namespace airlight
