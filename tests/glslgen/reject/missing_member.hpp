#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct S {
    T x;  ///< [L]
    T y;  ///< [L]
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
S<T> f(T x) {
    return S<T>{x};
}

}  // namespace airlight
