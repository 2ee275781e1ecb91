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
vec3<T> f(const vec3<T>& v, T x) {
    const vec3<T> a = vec3<T>(v.x, v.y, T(0)) * x + T(2) * v;
    const vec2<T> b = vec2<T>(T(1));
    const vec4<T> c = vec4<T>(a, x);
    vec3<T> d = -a / v;
    d.x = c.w;
    d *= x;
    d += v;
    return d * b.y;
}

}  // namespace airlight
