#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
vec3<T> f(const vec3<T>& v) {
    return vec3<T>(T(1)) - glm::exp(-v);
}

}  // namespace airlight
