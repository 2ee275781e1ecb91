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
    // Both branches are ours.
    if (x < T(0) || !(x != T(3))) {
        return -x;
    } else if (x > T(1) && x <= T(2)) {
        return x;  // in between
    } else {
        const bool small = x < T(0.5);
        return small ? T(0) : x;
    }
}

}  // namespace airlight
