#pragma once

#include <airlight/types.hpp>

#include <cmath>

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
    return std::sqrt(x);
}

}  // namespace airlight
