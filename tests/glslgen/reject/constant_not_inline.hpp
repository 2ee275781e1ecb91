#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Pi.
template <typename T>
constexpr T pi = T(3.14159L);

}  // namespace airlight
