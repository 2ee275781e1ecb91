#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Two.
template <typename T>
struct Atmosphere {
    T radius;  ///< [L]
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T quantity_with_a_long_name(const Atmosphere<T>& first_atmosphere, const Atmosphere<T>& second_atmosphere, T altitude,
                            const vec3<T>& direction, int steps) {
    return first_atmosphere.radius + second_atmosphere.radius + altitude + direction.x + T(steps);
}

}  // namespace airlight
