#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Half a number of nodes.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
constexpr int half_of(int nodes) {
    return nodes / 2 + 1;
}

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x, int n) {
    return x * T(half_of(n));
}

}  // namespace airlight
