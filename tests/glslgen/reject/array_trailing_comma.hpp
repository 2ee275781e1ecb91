#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Two numbers.
template <typename T>
inline constexpr T pair[2] = {
    T(1),
    T(2),
};

}  // namespace airlight
