#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A struct.
struct S {
    int n;  ///< [1]
};

}  // namespace airlight
