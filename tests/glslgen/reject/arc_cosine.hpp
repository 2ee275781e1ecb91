#pragma once

#include <airlight/types.hpp>

#include <glm/trigonometric.hpp>

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
    return glm::acos(x);
}

}  // namespace airlight
