#pragma once

// Where a table of the light that a habitat's air scatters keeps what: places in the cylinder to three
// coordinates and back.

#include <airlight/arc_tangent.hpp>
#include <airlight/habitat.hpp>
#include <airlight/linear_light.hpp>
#include <airlight/table_mapping.hpp>

namespace airlight {

/// The lights of a habitat: three strips on the wall along each half, a third of a turn apart, the first of
/// each half in the direction of the y axis. And how much finer a table of their light is at their ends.
template <typename T>
struct HabitatLights {
    T half_length;     ///< [L] of the cylinder
    T begin;           ///< [L] from the middle, where the strips of both halves begin
    T end;             ///< [L] where they end
    T width;           ///< [L] of each
    vec3<T> radiance;  ///< of each
    T fine;            ///< [L] on both sides of each end of a strip, a table's fine stretch
    T fine_share;      ///< [1] of a half's texels that each of these four gets
};

/// One of the six strips.
///
/// Units:    lights and air in one unit of length; i counts the strips, those of positive x first.
/// Domain:   i from 0 to 5.
/// Accuracy: 2 roundoffs.
/// Errors:   other numbers are strips of the half of negative x.
/// Source:   Rama, its Figure 1 and coordinates.
template <typename T>
LinearLight<T> habitat_strip(const HabitatAir<T>& air, const HabitatLights<T>& lights, int i) {
    const int turn = i < 3 ? i : i - 3;
    const T half_root_three = T(0.866025403784438646763723170752936183L);
    const T y = turn == 0 ? T(1) : T(-0.5);
    const T z = turn == 0 ? T(0) : turn == 1 ? half_root_three : -half_root_three;
    const T side = i < 3 ? T(1) : T(-1);
    const T middle = T(0.5) * side * (lights.begin + lights.end);
    return LinearLight<T>{vec3<T>(middle, air.radius * y, air.radius * z),
                          vec3<T>(T(1), T(0), T(0)),
                          vec3<T>(T(0), -y, -z),
                          T(0.5) * (lights.end - lights.begin),
                          lights.width,
                          lights.radiance};
}

/// The way along one of the stretches of a half, from 0 at its begin to 1 at its end and beyond.
///
/// Units:    x, begin and end in one unit; result [1].
/// Domain:   every number.
/// Accuracy: 2 roundoffs of x.
/// Errors:   a stretch without length is passed at its end.
/// Source:   none.
template <typename T>
T passed_of_stretch(T x, T begin, T end) {
    return end > begin ? share_of(x - begin, end - begin) : x < end ? T(0) : T(1);
}

/// Where along a half of the cylinder a table keeps a place: piecewise straight, steeper where strips end.
///
/// Units:    x [L] from the middle, its sign left away; result [1], 0 in the middle, 1 at the cap.
/// Domain:   fine > 0, stretches that do not meet; 4 fine_share below 1.
/// Accuracy: 16 roundoffs.
/// Errors:   places behind the cap count as the cap.
/// Source:   Rama, xWarp.
template <typename T>
T share_of_half(const HabitatLights<T>& lights, T x) {
    const T b = lights.begin;
    const T e = lights.end;
    const T f = lights.fine;
    const T wide = lights.fine_share;
    const T end_b = b / lights.half_length;
    const T end_e = e / lights.half_length;
    T sum = (end_b - wide) * passed_of_stretch(x, T(0), b - f);
    sum += T(2) * wide * passed_of_stretch(x, b - f, b + f);
    sum += (end_e - end_b - T(2) * wide) * passed_of_stretch(x, b + f, e - f);
    sum += T(2) * wide * passed_of_stretch(x, e - f, e + f);
    return sum + (T(1) - end_e - wide) * passed_of_stretch(x, e + f, lights.half_length);
}

/// The inverse of share_of_half.
///
/// Units:    share [1]; result [L].
/// Domain:   share in [0, 1].
/// Accuracy: 16 roundoffs of half_length.
/// Errors:   shares outside count as the end they are closer to.
/// Source:   as share_of_half.
template <typename T>
T place_of_half(const HabitatLights<T>& lights, T share) {
    const T b = lights.begin;
    const T e = lights.end;
    const T f = lights.fine;
    const T wide = lights.fine_share;
    const T end_b = b / lights.half_length;
    const T end_e = e / lights.half_length;
    T sum = (b - f) * passed_of_stretch(share, T(0), end_b - wide);
    sum += T(2) * f * passed_of_stretch(share, end_b - wide, end_b + wide);
    sum += (e - b - T(2) * f) * passed_of_stretch(share, end_b + wide, end_e - wide);
    sum += T(2) * f * passed_of_stretch(share, end_e - wide, end_e + wide);
    return sum + (lights.half_length - e - f) * passed_of_stretch(share, end_e + wide, T(1));
}

/// Where a table keeps a place: along the cylinder, the root of the way from the wall over the radius, and
/// the root of the angle from the nearest strip over a sixth of a turn, which by symmetry is all there is.
///
/// Units:    position [L]; result [1], each in [0, 1].
/// Domain:   places in the cylinder; those outside count as the nearest on its wall and caps.
/// Accuracy: 16 roundoffs, of roots that are 0 at the wall and at the strips.
/// Errors:   on the axis the angle is 0.
/// Source:   Rama, inscatterSource.
template <typename T>
vec3<T> unit_from_habitat(const HabitatAir<T>& air, const HabitatLights<T>& lights, const vec3<T>& position) {
    const T away = T(0.5) * share_of_half(lights, glm::abs(position.x));
    const T from_axis = glm::sqrt(position.y * position.y + position.z * position.z);
    // In sixths of a turn, from 0 to 3; strips at 0 and 2.
    const T sixths = arc_tangent(glm::abs(position.z), position.y) * (T(3) / pi<T>);
    const T from_strip = sixths < T(1) ? sixths : glm::abs(T(2) - sixths);
    return vec3<T>(position.x < T(0) ? T(0.5) - away : T(0.5) + away,
                   glm::sqrt(share_of(air.radius - from_axis, air.radius)),
                   glm::sqrt(share_of(from_strip, T(1))));
}

/// A place that unit_from_habitat takes to these coordinates: of the six, the one beside the first strip.
///
/// Units:    unit [1]; result [L].
/// Domain:   unit in [0, 1].
/// Accuracy: 16 roundoffs of half_length and radius.
/// Errors:   none.
/// Source:   as unit_from_habitat.
template <typename T>
vec3<T> habitat_from_unit(const HabitatAir<T>& air, const HabitatLights<T>& lights, const vec3<T>& unit) {
    const T away = T(2) * unit.x - T(1);
    const T along = place_of_half(lights, glm::abs(away));
    const vec2<T> turned = direction_at_angle(unit.z * unit.z * (pi<T> / T(3)));
    const T from_axis = air.radius * (T(1) - unit.y * unit.y);
    return vec3<T>(away < T(0) ? -along : along, from_axis * turned.x, from_axis * turned.y);
}

/// Texture coordinates of unit_from_habitat's, with the half texel at each edge.
///
/// Units:    unit [1]; sizes in texels; result [1].
/// Domain:   sizes >= 1.
/// Accuracy: that of texture_from_unit.
/// Errors:   those of texture_from_unit.
/// Source:   as texture_from_unit.
template <typename T>
vec3<T> habitat_texture(const vec3<T>& unit, int width, int height, int depth) {
    return vec3<T>(texture_from_unit(unit.x, width), texture_from_unit(unit.y, height),
                   texture_from_unit(unit.z, depth));
}

}  // namespace airlight
