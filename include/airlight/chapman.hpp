#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The scaled complementary error function, times the square root of pi.
///
///     sqrt(pi) exp(x^2) erfc(x) = 2 integral_0^infinity exp(-s^2 - 2 x s) ds
///
/// Units:    x [1]; result [1], sqrt(pi) at 0 and 1 / x for large x.
/// Domain:   x from 0 to 1e7.
/// Accuracy: relative 4.3e-8 by the fit, the same in every precision, plus 8 roundoffs.
/// Errors:   x < 0 is outside the fit; an x whose fifth power overflows gives NaN.
/// Source:   rational fit of degrees 4 and 5, tests/data/scaled_erfc_fit.py.
template <typename T>
inline T scaled_erfc(T x) {
    const T p2 = T(1.4982396857163418L) + x * (T(0.5057328013876545L) + x * T(0.0802671457609494L));
    const T p = T(1.7724539259492835L) + x * (T(2.3791069511441814L) + x * p2);
    const T q3 = T(1.5383162854428227L) + x * (T(0.5057339182244953L) + x * T(0.08026714236251309L));
    const T q = T(1) + x * (T(2.470650248615595L) + x * (T(2.6330695741803067L) + x * q3));
    return p / q;
}

/// Chapman's function upwards: the exponential air on a ray to space, over scale height times the
/// density at its start.
///
///     integral_0^infinity exp(-y) (x + y) / sqrt((y + a) (y + b)) dy,   a = x (1 - sine), b = x (1 + sine)
///
/// Expanded in y / b to second order, every term is a scaled complementary error function.
///
/// Units:    x = radius / scale height [1]; mu and sine of the angle to the vertical [1]; result [1].
/// Domain:   x >= 0; mu in [0, 1]; sine = sqrt(1 - mu^2) to rounding.
/// Accuracy: relative 4e-6 at x = 50, 5e-7 at 100, 1e-7 from 200 on, plus 16 roundoffs.
/// Errors:   none; below x = 50 the expansion fades out (3.3e-4 at 10, 2e-3 at 5, 2e-2 at 2), below 1 the
///           result fades to 1, which it is at 0: never off by more than 7 %.
/// Source:   docs/theory/chapman.md.
template <typename T>
T chapman(T x, T mu, T sine) {
    const T reach = glm::max(x, T(1));
    const T share = T(1) / (T(1) + sine);
    const T stretch = glm::sqrt(reach * share);
    const T w = mu * stretch;
    const T a = w * w;
    const T order_0 = scaled_erfc(w);
    const T order_1 = w + order_0 * (T(0.5) - a);
    const T order_2 = order_1 * (T(1.5) - a) + order_0 * a;
    const T weight_1 = (T(1) - T(0.5) * share) / reach;
    const T weight_2 = (T(0.375) * share - T(0.5)) * share / (reach * reach);
    const T series = stretch * (order_0 + weight_1 * order_1 + weight_2 * order_2);
    return T(1) + glm::min(x, T(1)) * glm::max(series - T(1), T(0));
}

}  // namespace airlight
