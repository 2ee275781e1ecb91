#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The share of light lost over an optical depth: 1 - exp(-x) without cancellation.
///
///     1 - exp(-x) = 2 x / (x + 2 (x / 2) coth(x / 2))
///
/// For small x the continued fraction of coth, which converges in every precision;
/// neither GLM nor GLSL has expm1.
///
/// Units:    x [1]; result [1].
/// Domain:   x >= 0, infinity included.
/// Accuracy: under 3 ulp in float, double and long double where exp is correctly rounded.
/// Errors:   none on the domain; x < 0 gives the (negative) value until exp overflows.
/// Source:   NIST Digital Library of Mathematical Functions, 4.39.1 (continued fraction of tanh).
template <typename T>
T one_minus_exp(T x) {
    if (glm::abs(x) < T(0.5)) {
        const T z = T(0.25) * x * x;
        T coth_part = T(15);
        for (int i = 0; i < 7; ++i) {
            coth_part = T(13 - 2 * i) + z / coth_part;
        }
        return T(2) * x / (x + T(2) * coth_part);
    }
    return T(1) - glm::exp(-x);
}

/// Square root of a quantity that rounding may have pushed below zero.
///
/// Units:    x in the square of the result's unit.
/// Domain:   every finite x; x < 0 is read as 0.
/// Accuracy: correctly rounded where the machine's square root is.
/// Errors:   none.
/// Source:   none.
template <typename T>
T safe_sqrt(T x) {
    return glm::sqrt(glm::max(x, T(0)));
}

}  // namespace airlight
