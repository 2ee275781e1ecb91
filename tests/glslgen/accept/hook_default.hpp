#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Hook: the share of light that a filter lets through.
struct HalfOfUpper {
    template <typename T>
    T operator()(const vec3<T>& position, T scale) const {
        return position.z * T(0.5) * scale;
    }
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T, typename ColourFilter = HalfOfUpper>
T filtered(const vec3<T>& position, const ColourFilter& colour_filter = ColourFilter{}) {
    return colour_filter(position * T(2), T(1) + T(2));
}

}  // namespace airlight
