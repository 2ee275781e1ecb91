#pragma once

#include <airlight/types.hpp>

#include <limits>

namespace airlight {

/// The distance that stands for none.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
constexpr T no_surface() {
    return std::numeric_limits<T>::infinity();
}

}  // namespace airlight
