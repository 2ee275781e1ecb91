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
    const T y[3] = {x, x};
    return y[0];
}

}  // namespace airlight
