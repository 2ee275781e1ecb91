#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
template <typename T>
struct S {
    T length;  ///< [L]
};

}  // namespace airlight
