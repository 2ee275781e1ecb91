#pragma once

#include <airlight/types.hpp>
#include <airlight/constants.hpp>

namespace airlight {

/// Uses another header.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T circle(T radius) {
    return pi<T>*radius * radius;
}

}  // namespace airlight
