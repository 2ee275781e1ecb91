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
T f(T x, const vec3<T>& v) {
    const T length = x;
    return length * glm::length(v);
}

}  // namespace airlight
