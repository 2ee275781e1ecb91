#pragma once

#include <airlight/types.hpp>

namespace airlight {

// A quantity.
template <typename T>
T f(T x) {
    return x;
}

}  // namespace airlight
