#pragma once

// The two units that tests state rounding errors in: ulp, where a function is well conditioned, and
// roundoffs times condition, where it is not.

#include <cmath>
#include <limits>

namespace airlight_test {

/// Distance between neighbouring numbers of type T at the magnitude of `x`; for 0 and below the smallest
/// normal number it is the smallest denormal.
template <typename T>
long double ulp_spacing(long double x) {
    using limits = std::numeric_limits<T>;
    int exponent = limits::min_exponent;
    if (x != 0.0L && std::isfinite(x)) {
        std::frexp(x, &exponent);
    }
    const int floor_exponent = exponent < limits::min_exponent ? limits::min_exponent : exponent;
    return std::ldexp(1.0L, floor_exponent - limits::digits);
}

/// |got - expected| in units in the last place of `expected` in type T. Infinite when one is NaN and the
/// other is not, or when they are different infinities; 0 when both are NaN or the same infinity.
template <typename T>
long double ulp_error(T got, long double expected) {
    const long double value = got;
    if (std::isnan(value) && std::isnan(expected)) {
        return 0.0L;
    }
    if (std::isinf(expected) || !std::isfinite(value)) {
        return value == expected ? 0.0L : std::numeric_limits<long double>::infinity();
    }
    if (std::isnan(expected)) {
        return std::numeric_limits<long double>::infinity();
    }
    return std::fabs(value - expected) / ulp_spacing<T>(expected);
}

/// Unit roundoff of T: the largest relative error of one correctly rounded operation.
template <typename T>
constexpr long double unit_roundoff() {
    return static_cast<long double>(std::numeric_limits<T>::epsilon()) / 2.0L;
}

/// |got - expected| in unit roundoffs of `condition`, which the caller forms as
/// sum(|df/dx| |x|) + |f|: how far the answer moves when every input moves by its own size.
template <typename T>
long double roundoff_error(T got, long double expected, long double condition) {
    const long double value = got;
    if (value == expected) {
        return 0.0L;
    }
    const long double error = std::fabs(value - expected) / (unit_roundoff<T>() * condition);
    return std::isnan(error) ? std::numeric_limits<long double>::infinity() : error;
}

/// What a table's expected value, rounded to long double, may itself be wrong by: half an ulp of a long
/// double, nothing that counts for the narrower types.
template <typename T>
constexpr long double table_rounding() {
    return std::numeric_limits<T>::digits == std::numeric_limits<long double>::digits ? 0.5L : 0.001L;
}

}  // namespace airlight_test
