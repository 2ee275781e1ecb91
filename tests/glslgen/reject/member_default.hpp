#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct S {
    T x = T(0);  ///< [1]
};

}  // namespace airlight
