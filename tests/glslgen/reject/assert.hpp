#pragma once

#include <airlight/types.hpp>

#include <cassert>

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
    assert(x > T(0));
    return x;
}

}  // namespace airlight
