#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct S {
    S() : x(T(0)) {}
    T x;  ///< [1]
};

}  // namespace airlight
