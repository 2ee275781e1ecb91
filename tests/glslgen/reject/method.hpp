#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct S {
    T x;  ///< [1]
    T twice() const { return T(2) * x; }
};

}  // namespace airlight
