#pragma once

// A scalar that carries, next to its float value, how far a second evaluation of the same formula may lie
// away. The library's functions are templates over the scalar, so running them on `Bounded` derives each
// result's tolerance from the operations the function really performs, at the very inputs under test: error
// of every operation times the condition of everything that follows. No tolerance is tuned by hand.
//
// Must be included before any airlight header: it adds overloads to namespace glm, where the headers look.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <type_traits>

namespace parity {

/// The pairs of evaluations that are compared; one bound is carried for each.
enum Comparison : std::size_t {
    software,   ///< this driver's shader against C++ float: only built-ins differ, by their measured error
    hardware,   ///< any conforming GPU against C++ float: the GLSL specification's table of operation errors
    precision,  ///< C++ float against C++ double on the same inputs
    comparisons
};

/// Largest error of one built-in of the driver, by the binade of its argument's magnitude.
struct BuiltinError {
    static constexpr int lowest = -24;
    static constexpr int binades = 56;
    std::array<double, binades> worst{};

    static std::size_t binade(double magnitude) {
        if (!(magnitude > 0)) {
            return 0;
        }
        const int e = std::isinf(magnitude) ? binades : std::ilogb(magnitude) - lowest;
        return static_cast<std::size_t>(std::clamp(e, 0, binades - 1));
    }
    /// Largest error anywhere between two magnitudes.
    double between(double low, double high) const {
        const auto begin = worst.begin();
        return *std::max_element(begin + static_cast<std::ptrdiff_t>(binade(low)),
                                 begin + static_cast<std::ptrdiff_t>(binade(high)) + 1);
    }
    void add(double magnitude, double error) {
        double& slot = worst[binade(magnitude)];
        slot = std::max(slot, error);
    }
};

/// What the driver's transcendental built-ins were measured to be off by (against the exact value).
struct DriverErrors {
    BuiltinError exp;   // relative, by |x|
    BuiltinError exp2;  // relative, by |x|
    BuiltinError log;   // absolute, by max(x, 1 / x) - 1
    BuiltinError log2;  // absolute, by max(x, 1 / x) - 1
    /// The measurement sees millions of arguments, not all of them: the bound allows twice what it saw.
    static constexpr double headroom = 2;
};

inline DriverErrors& driver_errors() {
    static DriverErrors errors;
    return errors;
}

/// Which comparisons met a branch that the bounded error could have turned the other way, since the last
/// reset.
inline std::array<bool, comparisons>& undecided_branches() {
    thread_local std::array<bool, comparisons> flags{};
    return flags;
}

class Bounded {
  public:
    using Bounds = std::array<double, comparisons>;

    Bounded() = default;
    template <typename N, typename = std::enable_if_t<std::is_arithmetic_v<N>>>
    explicit constexpr Bounded(N x)
        : value_(static_cast<float>(x)),
          // A literal is the same float in the shader; double holds more of its digits.
          bound_{0, 0, difference(static_cast<double>(x), static_cast<double>(static_cast<float>(x)))} {}
    Bounded(float value, const Bounds& bound) : value_(value), bound_(bound) {}

    float value() const {
        return value_;
    }
    const Bounds& bound() const {
        return bound_;
    }
    explicit operator float() const {
        return value_;
    }

    Bounded& operator+=(const Bounded& b);
    Bounded& operator-=(const Bounded& b);
    Bounded& operator*=(const Bounded& b);
    Bounded& operator/=(const Bounded& b);

  private:
    static constexpr double difference(double a, double b) {
        return a == b ? 0 : (a > b ? a - b : b - a);
    }
    float value_;  // without initialisers: glm keeps its components in a union
    Bounds bound_;
};

// ---- one operation: what its operands' errors become, and what it adds itself ----

/// Errors in units in the last place, from the GLSL 4.60 specification, section 4.7.1, "Range and precision".
/// One ulp of r is at most 2^-23 |r|. C++'s own rounding of the same operation adds half an ulp.
namespace spec {
constexpr double ulp = 0x1p-23;
constexpr double half_ulp = 0x1p-24;
constexpr double add = 0.5;         // a + b, a - b, a * b: correctly rounded
constexpr double divide = 2.5;      // a / b
constexpr double inverse_sqrt = 2;  // inversesqrt
constexpr double root = 2 + 2.5;    // sqrt: inherited from 1.0 / inversesqrt
inline double exp(double x) {       // exp, exp2: 3 + 2 |x|
    return 3 + 2 * std::abs(x);
}
constexpr double log = 3;                 // log, log2 outside [0.5, 2]
constexpr double log_near_one = 0x1p-21;  // absolute, inside [0.5, 2]
}  // namespace spec

/// glibc's float exp, exp2, log, log2 and pow are within 1 ulp (its manual, "Errors in math functions").
constexpr double libm_ulp = 1;

/// GPUs may flush results below the smallest normal float to zero (GLSL 4.60, 4.7.1); llvmpipe does.
inline constexpr double smallest_normal = 0x1p-126;

inline Bounded rounded(double exact_of_floats, const Bounded::Bounds& propagated, double spec_ulp) {
    const float value = static_cast<float>(exact_of_floats);
    if (!std::isfinite(value)) {
        return Bounded(value, {0, 0, 0});  // infinities and NaN must agree in kind; there is no distance
    }
    Bounded::Bounds bound = propagated;
    const double size = std::abs(static_cast<double>(value));
    // Equal operands round equally on software GL; operands that differ may round half an ulp apart each.
    bound[software] += propagated[software] > 0 ? spec::ulp * (size + propagated[software]) : 0;
    bound[hardware] += (spec_ulp + 0.5) * spec::ulp * (size + propagated[hardware]);
    bound[precision] += spec::half_ulp * (size + propagated[precision]);
    if (value != 0 || exact_of_floats != 0) {
        if (size - propagated[software] < smallest_normal) {
            bound[software] += smallest_normal;
        }
        if (size - propagated[hardware] < smallest_normal) {
            bound[hardware] += smallest_normal;
        }
        bound[precision] += size < smallest_normal ? 0x1p-149 : 0;
    }
    return Bounded(value, bound);
}

template <typename Each>
Bounded::Bounds for_each_comparison(Each each) {
    Bounded::Bounds out{};
    for (std::size_t k = 0; k < comparisons; ++k) {
        const double bound = each(k);
        out[k] = std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound;  // 0 * infinity
    }
    return out;
}

inline Bounded operator-(const Bounded& a) {
    return Bounded(-a.value(), a.bound());
}
inline Bounded operator+(const Bounded& a) {
    return a;
}
inline Bounded operator+(const Bounded& a, const Bounded& b) {
    const float sum = a.value() + b.value();
    return rounded(sum, for_each_comparison([&](std::size_t k) { return a.bound()[k] + b.bound()[k]; }),
                   spec::add);
}
inline Bounded operator-(const Bounded& a, const Bounded& b) {
    return a + (-b);
}
inline Bounded operator*(const Bounded& a, const Bounded& b) {
    const float product = a.value() * b.value();
    const double x = std::abs(static_cast<double>(a.value()));
    const double y = std::abs(static_cast<double>(b.value()));
    Bounded out = rounded(product, for_each_comparison([&](std::size_t k) {
                              return x * b.bound()[k] + y * a.bound()[k] + a.bound()[k] * b.bound()[k];
                          }),
                          spec::add);
    if (product == 0 && x != 0 && y != 0) {  // underflow
        out = Bounded(product,
                      for_each_comparison([&](std::size_t k) { return out.bound()[k] + smallest_normal; }));
    }
    return out;
}
inline Bounded operator/(const Bounded& a, const Bounded& b) {
    const float quotient = a.value() / b.value();
    const double size = std::abs(static_cast<double>(quotient));
    const double y = std::abs(static_cast<double>(b.value()));
    return rounded(
        quotient, for_each_comparison([&](std::size_t k) {
            const double left = y - b.bound()[k];
            const double error = a.bound()[k] + size * b.bound()[k];
            return error == 0 ? 0 : (left > 0 ? error / left : std::numeric_limits<double>::infinity());
        }),
        spec::divide);
}

inline Bounded& Bounded::operator+=(const Bounded& b) {
    return *this = *this + b;
}
inline Bounded& Bounded::operator-=(const Bounded& b) {
    return *this = *this - b;
}
inline Bounded& Bounded::operator*=(const Bounded& b) {
    return *this = *this * b;
}
inline Bounded& Bounded::operator/=(const Bounded& b) {
    return *this = *this / b;
}

inline Bounded& operator++(Bounded& a) {
    return a += Bounded(1);
}

/// Notes which comparisons the errors of a and b could turn the other way.
inline void note_decision(const Bounded& a, const Bounded& b) {
    const double gap = std::abs(static_cast<double>(a.value()) - static_cast<double>(b.value()));
    for (std::size_t k = 0; k < comparisons; ++k) {
        const double reach = a.bound()[k] + b.bound()[k];
        if (reach > 0 && gap <= reach) {
            undecided_branches()[k] = true;
        }
    }
}
inline bool operator<(const Bounded& a, const Bounded& b) {
    note_decision(a, b);
    return a.value() < b.value();
}
inline bool operator>(const Bounded& a, const Bounded& b) {
    return b < a;
}
inline bool operator<=(const Bounded& a, const Bounded& b) {
    note_decision(a, b);
    return a.value() <= b.value();
}
inline bool operator>=(const Bounded& a, const Bounded& b) {
    return b <= a;
}
inline bool operator==(const Bounded& a, const Bounded& b) {
    note_decision(a, b);
    return a.value() == b.value();
}
inline bool operator!=(const Bounded& a, const Bounded& b) {
    return !(a == b);
}

// ---- built-ins ----

inline Bounded abs(const Bounded& x) {
    return Bounded(std::abs(x.value()), x.bound());
}
/// The smaller (or larger) one is as sure as the surer of the two only where they cannot trade places.
inline Bounded chosen(const Bounded& a, const Bounded& b, bool take_a) {
    const double gap = std::abs(static_cast<double>(a.value()) - static_cast<double>(b.value()));
    const Bounded& taken = take_a ? a : b;
    return Bounded(taken.value(), for_each_comparison([&](std::size_t k) {
                       return gap > a.bound()[k] + b.bound()[k] ? taken.bound()[k]
                                                                : std::max(a.bound()[k], b.bound()[k]);
                   }));
}
inline Bounded min(const Bounded& a, const Bounded& b) {
    return chosen(a, b, !(b.value() < a.value()));
}
inline Bounded max(const Bounded& a, const Bounded& b) {
    return chosen(a, b, !(a.value() < b.value()));
}
inline Bounded clamp(const Bounded& x, const Bounded& low, const Bounded& high) {
    return min(max(x, low), high);
}
inline Bounded sqrt(const Bounded& x) {
    const double v = static_cast<double>(x.value());
    return rounded(
        std::sqrt(x.value()), for_each_comparison([&](std::size_t k) {
            const double e = x.bound()[k];
            const double sum = std::sqrt(std::max(v, 0.0)) + std::sqrt(std::max(v - e, 0.0));
            // (v - lowest) / (sqrt(v) + sqrt(lowest)); at v = 0 the root of the error itself.
            return e == 0 ? 0 : (sum > 0 ? std::max(e / sum, std::sqrt(v + e) - std::sqrt(v)) : std::sqrt(e));
        }),
        spec::root);
}
inline Bounded inversesqrt(const Bounded& x) {
    return Bounded(1) / sqrt(x);
}
inline Bounded floor(const Bounded& x) {
    const float below = std::floor(x.value());
    note_decision(x, Bounded(below, {}));
    note_decision(x, Bounded(below + 1, {}));
    return Bounded(below, {});
}
inline Bounded mix(const Bounded& a, const Bounded& b, const Bounded& t) {
    return a * (Bounded(1) - t) + b * t;
}

/// exp and exp2 alike: `rate` is ln 2 for exp2 and 1 for exp.
inline Bounded exponential(const Bounded& x, float value, double rate, const BuiltinError& driver) {
    if (!std::isfinite(value)) {
        return Bounded(value, {});
    }
    const double v = static_cast<double>(value);
    const double argument = static_cast<double>(x.value());
    const double size = std::abs(argument);
    return Bounded(
        value, for_each_comparison([&](std::size_t k) {
            // v may be 0 where the argument's own error is large: v exp(e) would then be 0 times infinity.
            const double e = x.bound()[k];
            const double reached = e < 1 ? v * std::exp(rate * e) : std::exp(rate * (argument + e));
            const double moved = e < 1 ? v * std::expm1(rate * e) : reached - v;
            const double own =
                k == software ? DriverErrors::headroom * driver.between(std::max(size - e, 0.0), size + e)
                              : (k == hardware ? spec::exp(size + e) * spec::ulp : 0);
            const double flush = k != precision && v < 4 * smallest_normal ? 4 * smallest_normal : 0x1p-149;
            return moved + reached * (own + libm_ulp * spec::ulp) + flush;
        }));
}
inline Bounded exp(const Bounded& x) {
    return exponential(x, std::exp(x.value()), 1, driver_errors().exp);
}
inline Bounded exp2(const Bounded& x) {
    return exponential(x, std::exp2(x.value()), 0.693147180559945309, driver_errors().exp2);
}

/// How far a logarithm's argument is from 1, on either side: what its error depends on.
inline double distance_from_one(double x) {
    return std::max(x, 1 / x) - 1;
}
inline double logarithm_error(std::size_t k, double x, double size, const BuiltinError& driver) {
    if (k == software) {
        const double d = distance_from_one(x);
        return DriverErrors::headroom * driver.between(d / 2, 2 * d);
    }
    if (k == hardware) {
        return x >= 0.5 && x <= 2 ? spec::log_near_one : spec::log * spec::ulp * size;
    }
    return 0;
}
/// log and log2 alike: `rate` is 1 / ln 2 for log2 and 1 for log.
inline Bounded logarithm(const Bounded& x, float value, double rate, const BuiltinError& driver) {
    if (!std::isfinite(value)) {
        return Bounded(value, {});
    }
    const double v = static_cast<double>(x.value());
    const double size = std::abs(static_cast<double>(value));
    return Bounded(
        value, for_each_comparison([&](std::size_t k) {
            const double e = x.bound()[k];
            const double moved =
                e == 0 ? 0 : (e < v ? -rate * std::log1p(-e / v) : std::numeric_limits<double>::infinity());
            return moved + logarithm_error(k, v, size + moved, driver) + libm_ulp * spec::ulp * size;
        }));
}
inline Bounded log(const Bounded& x) {
    return logarithm(x, std::log(x.value()), 1, driver_errors().log);
}
inline Bounded log2(const Bounded& x) {
    return logarithm(x, std::log2(x.value()), 1.44269504088896341, driver_errors().log2);
}
/// GLSL: pow(x, y) inherits the error of exp2(y * log2(x)); measured, llvmpipe evaluates exactly that.
inline Bounded pow(const Bounded& x, const Bounded& y) {
    const float value = std::pow(x.value(), y.value());
    if (!std::isfinite(value)) {
        return Bounded(value, {});
    }
    const double v = static_cast<double>(value);
    const double base = static_cast<double>(x.value());
    const double power = static_cast<double>(y.value());
    if (base <= 0) {
        return Bounded(value, {});  // pow(0, y > 0) is 0 on both sides
    }
    const double ln = std::log(base);
    return Bounded(
        value, for_each_comparison([&](std::size_t k) {
            const double ex = x.bound()[k];
            const double ey = y.bound()[k];
            const double ln_moved =
                ex == 0 ? 0 : (ex < base ? -std::log1p(-ex / base) : std::numeric_limits<double>::infinity());
            double exponent = std::abs(power) * ln_moved + ey * (std::abs(ln) + ln_moved);  // natural
            if (k != precision) {
                const double log2_size = std::abs(ln) * 1.44269504088896341 + ln_moved * 1.5;
                const double argument = std::abs(power) * log2_size;
                exponent +=
                    0.693147180559945309 *
                    ((std::abs(power) + ey) * logarithm_error(k, base, log2_size, driver_errors().log2) +
                     argument * spec::ulp);
                exponent += k == software ? DriverErrors::headroom *
                                                driver_errors().exp2.between(argument / 2, argument * 2)
                                          : spec::exp(argument) * spec::ulp;
            }
            const double flush = k != precision && v < 4 * smallest_normal ? 4 * smallest_normal : 0x1p-149;
            return v * std::expm1(exponent) + v * libm_ulp * spec::ulp + flush;
        }));
}

}  // namespace parity

template <>
struct std::numeric_limits<parity::Bounded> : std::numeric_limits<float> {
    static constexpr parity::Bounded infinity() {
        return parity::Bounded(std::numeric_limits<float>::infinity());
    }
    static constexpr parity::Bounded epsilon() {
        return parity::Bounded(std::numeric_limits<float>::epsilon());
    }
    static constexpr parity::Bounded max() {
        return parity::Bounded(std::numeric_limits<float>::max());
    }
    static constexpr parity::Bounded min() {
        return parity::Bounded(std::numeric_limits<float>::min());
    }
};

// The headers spell built-ins glm::exp and so on, which is looked up where the header stands: here they are.
namespace glm {
using parity::Bounded;
using BoundedVec3 = vec<3, Bounded, defaultp>;

using parity::abs;
using parity::clamp;
using parity::exp;
using parity::exp2;
using parity::floor;
using parity::inversesqrt;
using parity::log;
using parity::log2;
using parity::max;
using parity::min;
using parity::mix;
using parity::pow;
using parity::sqrt;

inline BoundedVec3 exp(const BoundedVec3& x) {
    return BoundedVec3(exp(x.x), exp(x.y), exp(x.z));
}
inline BoundedVec3 log(const BoundedVec3& x) {
    return BoundedVec3(log(x.x), log(x.y), log(x.z));
}
inline BoundedVec3 pow(const BoundedVec3& x, const BoundedVec3& y) {
    return BoundedVec3(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));
}
inline BoundedVec3 sqrt(const BoundedVec3& x) {
    return BoundedVec3(sqrt(x.x), sqrt(x.y), sqrt(x.z));
}
inline BoundedVec3 abs(const BoundedVec3& x) {
    return BoundedVec3(abs(x.x), abs(x.y), abs(x.z));
}
inline BoundedVec3 min(const BoundedVec3& a, const BoundedVec3& b) {
    return BoundedVec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z));
}
inline BoundedVec3 max(const BoundedVec3& a, const BoundedVec3& b) {
    return BoundedVec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z));
}
inline BoundedVec3 min(const BoundedVec3& a, const Bounded& b) {
    return min(a, BoundedVec3(b, b, b));
}
inline BoundedVec3 max(const BoundedVec3& a, const Bounded& b) {
    return max(a, BoundedVec3(b, b, b));
}
inline BoundedVec3 clamp(const BoundedVec3& x, const Bounded& low, const Bounded& high) {
    return min(max(x, low), high);
}
inline BoundedVec3 mix(const BoundedVec3& a, const BoundedVec3& b, const Bounded& t) {
    return a * (Bounded(1) - t) + b * t;
}
}  // namespace glm
