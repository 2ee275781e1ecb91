#pragma once

// What a table of 16-bit numbers holds, where light itself would be lost: from noon to deep twilight the sky
// falls by more powers of ten than a half has.

#include <airlight/types.hpp>

namespace airlight {

/// What a half holds instead of light: 256 times its square root. Light from 5.7e-14 to 65000 then keeps
/// three digits, where a half itself ends at 6e-8 and begins to lose digits at 6e-5.
///
/// Units:    light per unit of solar irradiance; result 256 times its root.
/// Domain:   light in [0, 65000]; below 0 counts as 0.
/// Accuracy: 1 roundoff; after rounding to a half the light is good to 1e-3, twice a half's roundoff.
/// Errors:   more than 65000 does not fit a half.
/// Source:   a square root is exact in hardware, which a logarithm is not, and 0 has one.
template <typename T>
vec3<T> stored_light(const vec3<T>& light) {
    return T(256) * glm::sqrt(glm::max(light, vec3<T>(T(0), T(0), T(0))));
}

/// The inverse of stored_light. Call it after filtering: between texels the root changes more evenly than
/// light does.
///
/// Units:    those of stored_light.
/// Domain:   every value whose square is finite.
/// Accuracy: 1 roundoff and twice the relative error of what was stored.
/// Errors:   none.
/// Source:   definition.
template <typename T>
vec3<T> light_from_stored(const vec3<T>& stored) {
    const vec3<T> root = T(0.00390625) * stored;
    return root * root;
}

}  // namespace airlight
