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
vec3<T> f(T x) {
    return vec3<T>{x, x, x};
}

}  // namespace airlight
