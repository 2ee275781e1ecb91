#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Rayleigh phase function, a polynomial.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
constexpr T rayleigh_phase(T cos_theta) {
    const T norm = T(3) / (T(16) * T(3.14159L));  // not the usual pi
    return norm * (T(1) + cos_theta * cos_theta);
}

}  // namespace airlight
