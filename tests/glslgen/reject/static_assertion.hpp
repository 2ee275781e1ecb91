#pragma once

#include <airlight/types.hpp>

namespace airlight {

static_assert(sizeof(int) == 4, "a 32-bit int");

}  // namespace airlight
