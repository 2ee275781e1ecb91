#pragma once

// What half precision keeps of a number: 11 bits, down to 2^-24, up to 65504.

#include <airlight/types.hpp>
#include <cmath>

namespace airlight_test {

/// The half-precision number next to `x`, to even where two are; infinite from 65520 on.
inline double as_half(double x) {
    if (!(std::fabs(x) < 65520.0)) {
        return std::isnan(x) ? x : std::copysign(INFINITY, x);
    }
    int exponent = 0;
    std::frexp(x, &exponent);
    const int last_bit = exponent < -13 ? -24 : exponent - 11;  // denormal numbers are evenly spaced
    return std::ldexp(std::nearbyint(std::ldexp(x, -last_bit)), last_bit);
}

template <typename T>
airlight::vec2<T> as_half(const airlight::vec2<T>& v) {
    return airlight::vec2<T>(T(as_half(double(v.x))), T(as_half(double(v.y))));
}

template <typename T>
airlight::vec3<T> as_half(const airlight::vec3<T>& v) {
    return airlight::vec3<T>(T(as_half(double(v.x))), T(as_half(double(v.y))), T(as_half(double(v.z))));
}

}  // namespace airlight_test
