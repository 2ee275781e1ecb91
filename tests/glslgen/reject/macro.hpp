#pragma once

#include <airlight/types.hpp>

namespace airlight {

#define TWICE(x) ((x) + (x))

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x) {
    return TWICE(x);
}

}  // namespace airlight
