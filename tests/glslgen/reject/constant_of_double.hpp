#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Pi.
inline constexpr double pi = 3.14159;

}  // namespace airlight
