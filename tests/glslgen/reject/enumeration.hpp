#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Choices.
enum class Choice { one, two };

}  // namespace airlight
