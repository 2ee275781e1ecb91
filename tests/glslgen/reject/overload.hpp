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
    return x;
}

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x, T y) {
    return x * y;
}

}  // namespace airlight
