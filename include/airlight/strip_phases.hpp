#pragma once

// Beside a strip of light its width shows, and a narrow lobe sees its edges: the phase functions' means over
// the rectangle that it is.

#include <airlight/gauss.hpp>
#include <airlight/linear_light.hpp>
#include <airlight/phase.hpp>

namespace airlight {

/// What Draine's phase function has above an even one within a cone about its axis, over the square of the
/// cone's sine, and times the denominator of Henyey and Greenstein: with that, next to no peak is left.
///
///     s^2 / (1 - c^2) integral_c^1 (p(c') - 1 / (4 pi)) dc',   s^2 = 1 + g^2 - 2 g c
///
/// divided out, so that nothing cancels and neither end is a pole.
///
/// Units:    cos_theta, g and alpha [1]; result [1/sr].
/// Domain:   cos_theta in [-1, 1]; g in [0, 1); alpha >= 0, of draine_phase.
/// Accuracy: 2 roundoffs of 1 for g to 0.95 and alpha to 2.
/// Errors:   none.
/// Source:   docs/theory/linear_light.md.
template <typename T>
T draine_excess(T cos_theta, T g, T alpha) {
    const T s = glm::sqrt(henyey_greenstein_denominator(cos_theta, g));
    const T even = g * (s + T(2));
    const T bent = g * (T(3) + T(2) * g * g) + (T(2) * cos_theta - g) / (T(1) + s) +
                   cos_theta * (T(1) - g * g) + T(2) * g * (T(1) + g * g) * s;
    const T third = alpha / T(3);
    const T norm = T(2) * pi<T> * (T(1) + third * (T(1) + T(2) * g * g));
    return s * (even + third * bent) / (norm * (s + (T(1) - g)) * (s + (T(1) + g)));
}

/// What one edge adds to the integral of Draine's phase function over a polygon of directions, above that of
/// an even one: the integral over a polygon is a sum over its edges.
///
///     (n . direction) integral along the edge of draine_excess / s^2,   n = begin x end / |begin x end|
///
/// By the rule of Gauss and Legendre with 4 points, evenly in the integral of 1 / s^2: they crowd where the
/// edge passes through the lobe, however narrow it is.
///
/// Units:    begin, end and direction unit vectors; g and alpha [1]; result [1].
/// Domain:   edges shorter than half a circle, the polygon on the side of n; g in (-1, 1); alpha >= 0, of
///           draine_phase.
/// Accuracy: 5e-4 for |g| to 0.95, plus 32 roundoffs over the edge's sine.
/// Errors:   an edge without length or of half a circle adds nothing; g = 1 or -1 may divide by zero.
/// Source:   docs/theory/linear_light.md.
template <typename T>
T draine_phase_edge(const vec3<T>& begin, const vec3<T>& end, const vec3<T>& direction, T g, T alpha) {
    const vec3<T> turned = cross_of_unit_vectors(begin, end);
    const T sine = glm::sqrt(dot_product(turned, turned));
    if (sine <= T(0)) {
        return T(0);
    }
    const vec3<T> normal = turned / sine;
    const vec3<T> lobe = (g < T(0) ? T(-1) : T(1)) * direction;
    const T strength = glm::abs(g);
    // The lobe's axis in the edge's plane: its part off the plane, and where the edge begins from its foot.
    const T off_plane = dot_product(lobe, normal);
    const T ahead = dot_product(lobe, begin);
    const T aside = dot_product(lobe, glm::cross(begin, normal));
    const T in_plane = glm::sqrt(ahead * ahead + aside * aside);
    // The denominator at the edge's nearest to the lobe, and opposite.
    const T least =
        (T(1) - strength) * (T(1) - strength) + T(2) * strength * (off_plane * off_plane / (T(1) + in_plane));
    const T most = least + T(4) * strength * in_plane;
    const T spread = glm::sqrt(least * most);
    // Half the angle from the foot, at the edge's begin and end; of its two forms the one that adds. A lobe
    // at right angles to the plane has no foot, and any will do.
    const T cosine_begin = in_plane > T(0) ? ahead / in_plane : T(1);
    const T sine_begin = in_plane > T(0) ? aside / in_plane : T(0);
    const T less = sine_begin < T(0) ? cosine_begin - T(1) : T(1) - cosine_begin;
    const T half_x = cosine_begin < T(0) ? glm::abs(sine_begin) : T(1) + cosine_begin;
    const T half_y = cosine_begin < T(0) ? less : sine_begin;
    const vec3<T> chord = end - begin;
    const vec3<T> both = end + begin;
    const T turn_x = glm::sqrt(dot_product(both, both));
    const T turn_y = glm::sqrt(dot_product(chord, chord));
    const T end_x = half_x * turn_x - half_y * turn_y;
    const T end_y = half_y * turn_x + half_x * turn_y;
    // The angle whose differential is that of the edge over the denominator, from end to end.
    const T reach_x = least * half_x * end_x + most * half_y * end_y;
    const T reach_y = spread * (half_x * half_x + half_y * half_y) * turn_y;
    const T reach = arc_tangent(reach_y, reach_x);
    // Twice that angle in the middle, without its cosine.
    const T begin_x = least * half_x * half_x - most * half_y * half_y;
    const T begin_y = T(2) * spread * half_x * half_y;
    const T middle_x = begin_x * reach_x - begin_y * reach_y;
    const T middle_y = begin_y * reach_x + begin_x * reach_y;
    const T middle = glm::sqrt(middle_x * middle_x + middle_y * middle_y);
    const T middle_cosine = middle > T(0) ? middle_x / middle : T(1);
    const T middle_sine = middle > T(0) ? middle_y / middle : T(0);
    const T mean = T(0.5) * (most + least);
    const T swing = T(2) * strength * in_plane;
    T sum = T(0);
    // The rule's points lie in pairs about the middle.
    for (int i = 0; i < 2; ++i) {
        const vec2<T> quarter = direction_at_angle(T(0.5) * reach * (gauss_4_positions<T>[i] - T(0.5)));
        const T half_cosine = (quarter.x - quarter.y) * (quarter.x + quarter.y);
        const T half_sine = T(2) * quarter.x * quarter.y;
        const T level = middle_cosine * ((half_cosine - half_sine) * (half_cosine + half_sine));
        const T aslant = middle_sine * (T(2) * half_cosine * half_sine);
        const T before = in_plane * (swing + mean * (level + aslant)) / (mean + swing * (level + aslant));
        const T behind = in_plane * (swing + mean * (level - aslant)) / (mean + swing * (level - aslant));
        sum += gauss_4_weights<T>[i] * (draine_excess(glm::clamp(before, T(-1), T(1)), strength, alpha) +
                                        draine_excess(glm::clamp(behind, T(-1), T(1)), strength, alpha));
    }
    return off_plane * sum * (T(2) * reach / spread);
}

/// What draine_phase_edge is for Rayleigh's phase function, without an integral left.
///
///     (n . direction) direction . ((end - begin) x n) / (16 pi)
///
/// Units:    begin, end and direction unit vectors; result [1].
/// Domain:   that of draine_phase_edge.
/// Accuracy: 8 roundoffs, plus as many over the edge's sine.
/// Errors:   an edge without length or of half a circle adds nothing.
/// Source:   draine_excess for g = 0 and alpha = 1 is cos_theta / (16 pi).
template <typename T>
T rayleigh_phase_edge(const vec3<T>& begin, const vec3<T>& end, const vec3<T>& direction) {
    const vec3<T> turned = cross_of_unit_vectors(begin, end);
    const T sine2 = dot_product(turned, turned);
    if (sine2 <= T(0)) {
        return T(0);
    }
    const vec3<T> chord = end - begin;
    return dot_product(turned, direction) * dot_product(glm::cross(chord, turned), direction) /
           (T(16) * pi<T> * sine2);
}

/// Means of the phase functions over the rectangle that a strip of light is to a place.
template <typename T>
struct StripPhases {
    T rayleigh;  ///< [1/sr]
    T mie;       ///< [1/sr]
};

/// Means of the phase functions over the solid angle of the rectangle that a strip of light is.
///
///     1 / (4 pi) + sum of the four edges / solid_angle
///
/// Units:    position [L]; direction a unit vector, away from the eye; solid_angle of strip_view [sr]; mie_g
///           of the aerosol's phase function.
/// Domain:   places before the strip and within 32 widths of it, solid_angle > 0; mie_g in (-1, 1).
/// Accuracy: Rayleigh's 3e-6, aerosol's with mie_g to 0.8 0.5 %; in float 64 roundoffs over the solid angle.
/// Errors:   never outside what the phase functions take; phase_fog's aerosol counts as even.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene>
StripPhases<T> strip_phases(const LinearLight<T>& light, const vec3<T>& position, const vec3<T>& direction,
                            T solid_angle, T mie_g) {
    const vec3<T> a = strip_corner(light, position, T(-1), T(-1));
    const vec3<T> b = strip_corner(light, position, T(-1), T(1));
    const vec3<T> c = strip_corner(light, position, T(1), T(1));
    const vec3<T> d = strip_corner(light, position, T(1), T(-1));
    T bend = rayleigh_phase_edge(a, b, direction);
    bend += rayleigh_phase_edge(b, c, direction);
    bend += rayleigh_phase_edge(c, d, direction);
    bend += rayleigh_phase_edge(d, a, direction);
    const T rayleigh =
        glm::clamp(isotropic_phase<T>() + bend / solid_angle, rayleigh_phase(T(0)), rayleigh_phase(T(1)));
    T mie = isotropic_phase<T>();
    if constexpr (Scene::mie && Scene::mie_phase != phase_fog) {
        const T alpha = Scene::mie_phase == phase_cornette_shanks ? T(1) : T(0);
        T lobe = draine_phase_edge(a, b, direction, mie_g, alpha);
        lobe += draine_phase_edge(b, c, direction, mie_g, alpha);
        lobe += draine_phase_edge(c, d, direction, mie_g, alpha);
        lobe += draine_phase_edge(d, a, direction, mie_g, alpha);
        mie = glm::clamp(mie + lobe / solid_angle, T(0), draine_phase(T(1), glm::abs(mie_g), alpha));
    }
    return StripPhases<T>{rayleigh, mie};
}

}  // namespace airlight
