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
T f(T x) {
    T y = x;
    const int n = 3;
    for (int i = 0; i < n; ++i) {
        y += x;
    }
    return y;
}

}  // namespace airlight
