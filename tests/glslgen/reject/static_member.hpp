#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct S {
    T x;  ///< [1]
    static constexpr int n = 3;  ///< three
};

}  // namespace airlight
