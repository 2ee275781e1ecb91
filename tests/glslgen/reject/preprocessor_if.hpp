#pragma once

#include <airlight/types.hpp>

namespace airlight {

#if 1
/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x) {
    return x;
}
#endif

}  // namespace airlight
