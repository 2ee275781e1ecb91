#pragma once

// Integrals for tests, in long double, by a rule that the library does not use.

#include <cmath>

namespace airlight_test {

/// Integral of a smooth function over [a, b]: tanh-sinh, halving the step until two answers agree to
/// `tolerance` (relative). Endpoint singularities of derivatives do no harm; kinks inside do.
template <typename Function>
long double integrate(Function f, long double a, long double b, long double tolerance = 1e-16L) {
    const long double half = (b - a) / 2;
    const long double half_pi = 1.57079632679489661923132169163975144L;
    const auto term = [&](long double t) {
        // Distance from the nearer end, formed without cancellation.
        const long double u = half_pi * std::sinh(t);
        const long double from_end = 2 * half / (1 + std::exp(2 * std::fabs(u)));
        const long double weight = half_pi * std::cosh(t) / (std::cosh(u) * std::cosh(u));
        return weight * f(u < 0 ? a + from_end : b - from_end);
    };
    long double step = 0.5L;
    const long double reach = 4.2L;
    long double sum = term(0);
    for (long double t = step; t <= reach; t += step) {
        sum += term(t) + term(-t);
    }
    long double previous = sum * step * half;
    for (int level = 0; level < 9; ++level) {
        step /= 2;
        for (long double t = step; t <= reach; t += 2 * step) {
            sum += term(t) + term(-t);
        }
        const long double now = sum * step * half;
        if (level > 1 && std::fabs(now - previous) <= tolerance * std::fabs(now)) {
            return now;
        }
        previous = now;
    }
    return previous;
}

/// Integral of f(cos_theta) over the sphere of directions.
template <typename Function>
long double integrate_sphere(Function f, long double tolerance = 1e-16L) {
    const long double two_pi = 6.28318530717958647692528676655900577L;
    long double sum = integrate(f, -1.0L, 0.0L, tolerance);
    // Panels that shrink towards forward scattering, where narrow lobes stand.
    long double begin = 0.0L;
    for (int i = 1; i <= 16; ++i) {
        const long double end = 1.0L - std::ldexp(1.0L, -i);
        sum += integrate(f, begin, end, tolerance);
        begin = end;
    }
    return two_pi * (sum + integrate(f, begin, 1.0L, tolerance));
}

}  // namespace airlight_test
