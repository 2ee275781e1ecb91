#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
vec3<T> f(const vec3<T>& v, T x, int n) {
    T s = glm::abs(x) + glm::ceil(x) + glm::floor(x) + glm::fract(x) + glm::sign(x) + glm::trunc(x);
    s += glm::exp(x) + glm::exp2(x) + glm::log(x) + glm::log2(x) + glm::sqrt(x) + glm::inversesqrt(x);
    s += glm::clamp(x, T(0), T(1)) + glm::mix(T(1), T(2), x) + glm::mod(x, T(3)) + glm::pow(x, T(2.4));
    s += glm::step(T(1), x) + glm::smoothstep(T(0), T(1), x);
    const vec3<T> w = glm::cross(v, v) + glm::min(v, x) + glm::max(v, v);
    return s * glm::exp(-w) + glm::clamp(v, T(0), T(1)) + glm::mix(v, w, x) + T(glm::max(glm::min(n, 3), 0));
}

}  // namespace airlight
