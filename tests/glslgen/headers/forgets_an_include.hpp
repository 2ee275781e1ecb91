#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Calls what only its includer includes.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T forgetful(T x) {
    return one_minus_exp(x);
}

}  // namespace airlight
