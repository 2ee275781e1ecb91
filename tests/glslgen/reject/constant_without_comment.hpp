#pragma once

#include <airlight/types.hpp>

namespace airlight {

template <typename T>
inline constexpr T pi = T(3.14159L);

}  // namespace airlight
