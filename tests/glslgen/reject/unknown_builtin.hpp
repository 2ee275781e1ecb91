#pragma once

#include <airlight/types.hpp>

#include <glm/glm.hpp>

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
    return glm::roundEven(x);
}

}  // namespace airlight
