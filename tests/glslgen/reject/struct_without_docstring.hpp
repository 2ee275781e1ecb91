#pragma once

#include <airlight/types.hpp>

namespace airlight {

template <typename T>
struct S {
    T x;  ///< [L]
};

}  // namespace airlight
