#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// AIRLIGHT_CPU_ONLY
template <typename T>
T slow(T x) {
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
T f(T x) {
    return slow(x);
}

}  // namespace airlight
