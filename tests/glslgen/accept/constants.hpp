#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Circumference of a circle over its diameter [1].
template <typename T>
inline constexpr T pi = T(3.14159265358979323846264338327950288L);

/// Twice that [1].
template <typename T>
inline constexpr T two_pi = T(2) * pi<T>;
template <typename T>
inline constexpr T half_pi = T(0.5) * pi<T>;  ///< [1] a quarter of a turn

/// A direction.
template <typename T>
inline constexpr vec3<T> up = vec3<T>(T(0), T(0), T(1));

/// Abscissae of Gauss and Legendre on [-1, 1], two nodes [1].
template <typename T>
inline constexpr T abscissa[2] = {
    T(-0.57735026918962576L),  // left
    T(0.57735026918962576L)    // right
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x) {
    return two_pi<T> * x + half_pi<T> * abscissa<T>[0] + up<T>.z;
}

}  // namespace airlight
