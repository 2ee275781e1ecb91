#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A name for the same.
template <typename T>
using direction = vec3<T>;

}  // namespace airlight
