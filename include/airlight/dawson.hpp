#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Dawson's integral: what lies below a Gaussian that grows, over its last value.
///
///     D(x) = exp(-x^2) integral_0^x exp(s^2) ds
///
/// Units:    x and result [1]; about x for small x, 1 / (2 x) for large, 0.541 at most.
/// Domain:   every finite x; odd.
/// Accuracy: relative 1.1e-7 by the fit, the same in every precision, plus 12 roundoffs; beyond 300 6e-6.
/// Errors:   none.
/// Source:   rational fit of degrees 7 and 8 in x^2, tests/data/dawson_fit.py.
template <typename T>
T dawson(T x) {
    // Beyond, powers of x would overflow, and the function falls as 1 / x.
    const T held = glm::clamp(x, T(-300), T(300));
    const T y = held * held;
    const T p4 =
        T(0.0008140948973248078L) +
        y * (T(0.00010979319422951286L) + y * (T(2.757881888630631e-06L) + y * T(1.1845790302972281e-06L)));
    const T p = T(0.999999908321961L) +
                y * (T(0.08733364711345294L) +
                     y * (T(0.042718009278798215L) + y * (T(0.006208845898073251L) + y * p4)));
    const T q5 =
        T(0.0015041612595593666L) +
        y * (T(0.00021572817465374187L) + y * (T(4.3308702596771276e-06L) + y * T(2.3691582516083276e-06L)));
    const T q = T(1) + y * (T(0.7539958061040095L) +
                            y * (T(0.278751633790593L) +
                                 y * (T(0.06705197478757119L) + y * (T(0.011894278657234946L) + y * q5))));
    const T fall = T(300) / glm::max(glm::abs(x), T(300));
    return held * (p / q) * fall;
}

}  // namespace airlight
