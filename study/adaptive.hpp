#pragma once

// Integrals of several functions at once, halving where the rule is not sure of itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

namespace study {

using Real = long double;
using Three = std::array<Real, 3>;

inline Three operator+(const Three& a, const Three& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Three operator-(const Three& a, const Three& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Three operator*(Real k, const Three& a) {
    return {k * a[0], k * a[1], k * a[2]};
}
/// The largest magnitude of the three.
inline Real size(const Three& a) {
    return std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
}

/// An integral, and how far the rule of 7 points is from that of 15: an error that the latter does not have
/// by far.
struct Estimate {
    Three value;
    Three doubt;
};

/// The rule of Gauss and Kronrod with 7 and 15 points (Piessens et al., QUADPACK, 1983) on [a, b].
template <typename Function>
Estimate gauss_kronrod(const Function& f, Real a, Real b) {
    static constexpr Real points[8] = {
        0.991455371120812639206854697526329L, 0.949107912342758524526189684047851L,
        0.864864423359769072789712788640926L, 0.741531185599394439863864773280788L,
        0.586087235467691130294144691258380L, 0.405845151377397166906606412076961L,
        0.207784955007898467600689403773245L, 0.0L};
    static constexpr Real kronrod[8] = {
        0.022935322010529224963732008058970L, 0.063092092629978553290700663189204L,
        0.104790010322250183839876322541518L, 0.140653259715525918745189590510238L,
        0.169004726639267902826583426598550L, 0.190350578064785409913256402421014L,
        0.204432940075298892414161999234649L, 0.209482141084727828012999174891714L};
    static constexpr Real gauss[4] = {
        0.129484966168869693270611432679082L, 0.279705391489276667901467771423780L,
        0.381830050505118944950369775488975L, 0.417959183673469387755102040816327L};
    const Real middle = (a + b) / 2;
    const Real half = (b - a) / 2;
    const Three at_middle = f(middle);
    Three fine = kronrod[7] * at_middle;
    Three coarse = gauss[3] * at_middle;
    for (int i = 0; i < 7; ++i) {
        const Three pair = f(middle - half * points[i]) + f(middle + half * points[i]);
        fine = fine + kronrod[i] * pair;
        if (i % 2 == 1) {
            coarse = coarse + gauss[i / 2] * pair;
        }
    }
    return {half * fine, half * (fine - coarse)};
}

/// Integral of f over [a, b], halved until `enough(doubt)` says of every part that it is good.
template <typename Function, typename Enough>
Three integral(const Function& f, Real a, Real b, const Enough& enough, int halvings = 40) {
    const Estimate whole = gauss_kronrod(f, a, b);
    if (halvings == 0 || enough(whole)) {
        return whole.value;
    }
    const Real middle = (a + b) / 2;
    return integral(f, a, middle, enough, halvings - 1) + integral(f, middle, b, enough, halvings - 1);
}

}  // namespace study
