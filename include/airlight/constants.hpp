#pragma once

#include <limits>

namespace airlight {

/// Circumference of a circle over its diameter [1].
template <typename T>
inline constexpr T pi = T(3.14159265358979323846264338327950288L);

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
