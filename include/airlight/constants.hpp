#pragma once

#include <limits>

namespace airlight {

/// Circumference of a circle over its diameter [1].
template <typename T>
inline constexpr T pi = T(3.14159265358979323846264338327950288L);

/// Where the four-point rule of Gauss and Legendre takes its samples on [0, 1] [1].
template <typename T>
inline constexpr T gauss_4_positions[4] = {
    T(0.0694318442029737123880267555535953L), T(0.330009478207571867598667120448378L),
    T(0.669990521792428132401332879551622L), T(0.930568155797026287611973244446405L)};

/// What each of those samples counts [1]; the sum is 1.
template <typename T>
inline constexpr T gauss_4_weights[4] = {
    T(0.173927422568726928686531974610999L), T(0.326072577431273071313468025389001L),
    T(0.326072577431273071313468025389001L), T(0.173927422568726928686531974610999L)};

/// The distance that says "the view ray ends on no surface".
///
/// Units:    result in the caller's length unit [L].
/// Domain:   none, it takes no argument.
/// Accuracy: exact; infinite in C++, 1e30 in GLSL, where infinity is not guaranteed.
/// Errors:   none.
/// Source:   a convention of this library.
template <typename T>
constexpr T no_surface() {
    return std::numeric_limits<T>::infinity();
}

}  // namespace airlight
