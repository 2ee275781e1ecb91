#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct B {
    T x;  ///< [1]
};

/// Another.
template <typename T>
struct S : B<T> {
    T y;  ///< [1]
};

}  // namespace airlight
