#pragma once

#include <airlight/constants.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// The angle between a direction and the x axis, by nothing but + - * / and a root: GLSL's own atan is free
/// to be off by 4096 ulp.
///
///     atan2(y, x) = 2 atan(y / (|x| + sqrt(x^2 + y^2))), or pi less that where x < 0
///
/// Units:    y and x in one unit; result [rad], from 0 to pi.
/// Domain:   y >= 0; x^2 + y^2 finite.
/// Accuracy: relative 2.1e-8 by the fit, the same in every precision, plus 8 roundoffs; where x < 0, of the
///           angle left to pi only absolute.
/// Errors:   0 where both are 0, or so small that their squares are; y < 0 gives the angle's negative where
///           x >= 0.
/// Source:   rational fit of degrees 2 and 3, tests/data/arc_tangent_fit.py.
template <typename T>
T arc_tangent(T y, T x) {
    const T reach = glm::abs(x) + glm::sqrt(x * x + y * y);
    const T t = reach > T(0) ? y / reach : T(0);
    const T t2 = t * t;
    const T p = T(0.9999999797687155L) + t2 * (T(0.8983975893825432L) + t2 * T(0.13761331954138484L));
    const T q =
        T(1) + t2 * (T(1.2317288735479741L) + t2 * (T(0.34822292649982584L) + t2 * T(0.012377829424008502L)));
    const T angle = T(2) * t * (p / q);
    return x < T(0) ? pi<T> - angle : angle;
}

/// The direction at an angle from the x axis, the other way round: its cosine and its sine.
///
/// Units:    angle [rad]; result [1], cosine first.
/// Domain:   angle from -1.1 to 1.1.
/// Accuracy: 4e-13 by the series, plus 4 roundoffs.
/// Errors:   beyond the domain a polynomial that is neither.
/// Source:   Taylor's series.
template <typename T>
vec2<T> direction_at_angle(T angle) {
    const T a = angle * angle;
    const T c8 =
        T(1) / T(40320) - a * (T(1) / T(3628800) - a * (T(1) / T(479001600) - a * (T(1) / T(87178291200))));
    const T s9 = T(1) / T(362880) -
                 a * (T(1) / T(39916800) - a * (T(1) / T(6227020800) - a * (T(1) / T(1307674368000))));
    const T a4 = (a * a) * (a * a);
    const T c = T(1) - a * (T(0.5) - a * (T(1) / T(24) - a * (T(1) / T(720))));
    const T s = T(1) - a * (T(1) / T(6) - a * (T(1) / T(120) - a * (T(1) / T(5040))));
    return vec2<T>(c + a4 * c8, angle * (s + a4 * s9));
}

}  // namespace airlight
