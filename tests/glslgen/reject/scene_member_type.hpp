#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The terms of a scene.
struct DefaultScene {
    static constexpr float g = 0.8f;  ///< [1]
};

}  // namespace airlight
