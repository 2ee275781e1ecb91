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
T f(T x, int n) {
    T sum = T(0);
    for (int i = 0; i < n; ++i) {
        for (int j = 1; j < 4; ++j) {
            sum += T(i + j) * x;
        }
        if (sum > x) {
            break;
        }
    }
    return sum;
}

}  // namespace airlight
