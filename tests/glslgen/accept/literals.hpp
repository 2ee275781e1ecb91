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
    const T a = T(2) + T(0.5) + T(.5) + T(2.) + T(1e-3) + T(1e30L) + T(-1) + T(1'000);
    const T b = x - T(-0.25);
    const int n = 3;
    return a * b * T(n) + T(2 * n + 1);
}

}  // namespace airlight
