#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Here alone the pattern may stand.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T one_minus_exp(T x) {
    return T(1) - glm::exp(-x);
}

}  // namespace airlight
