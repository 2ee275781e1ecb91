#pragma once

#include <airlight/types.hpp>

namespace airlight {

template <typename T>
T f(T x) {
    return x;
}

}  // namespace airlight
