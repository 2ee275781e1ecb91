#pragma once

// A scalar that counts what is done with it: run a template of airlight on it, and the exponentials, roots
// and divisions of one ray are known.
//
// Must be included before any airlight header: it adds overloads to namespace glm, where the headers look.

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <type_traits>

namespace study {

struct Counts {
    double exponentials = 0;  ///< exp, exp2 and pow
    double roots = 0;         ///< sqrt and inversesqrt
    double divisions = 0;
};

/// What this thread has counted so far.
inline Counts& counts() {
    thread_local Counts all;
    return all;
}

class Counted {
  public:
    Counted() = default;
    template <typename N, typename = std::enable_if_t<std::is_arithmetic_v<N>>>
    explicit constexpr Counted(N x) : value_(static_cast<double>(x)) {}

    constexpr double value() const {
        return value_;
    }
    explicit constexpr operator double() const {
        return value_;
    }

    Counted& operator+=(Counted b) {
        value_ += b.value_;
        return *this;
    }
    Counted& operator-=(Counted b) {
        value_ -= b.value_;
        return *this;
    }
    Counted& operator*=(Counted b) {
        value_ *= b.value_;
        return *this;
    }
    Counted& operator/=(Counted b) {
        ++counts().divisions;
        value_ /= b.value_;
        return *this;
    }

  private:
    double value_;  // without initialiser: glm keeps its components in a union
};

inline Counted operator-(Counted a) {
    return Counted(-a.value());
}
inline Counted operator+(Counted a) {
    return a;
}
inline Counted operator+(Counted a, Counted b) {
    return a += b;
}
inline Counted operator-(Counted a, Counted b) {
    return a -= b;
}
inline Counted operator*(Counted a, Counted b) {
    return a *= b;
}
inline Counted operator/(Counted a, Counted b) {
    return a /= b;
}
inline Counted& operator++(Counted& a) {
    return a += Counted(1);
}
inline bool operator<(Counted a, Counted b) {
    return a.value() < b.value();
}
inline bool operator>(Counted a, Counted b) {
    return a.value() > b.value();
}
inline bool operator<=(Counted a, Counted b) {
    return a.value() <= b.value();
}
inline bool operator>=(Counted a, Counted b) {
    return a.value() >= b.value();
}

inline bool operator==(Counted a, Counted b) {
    return a.value() == b.value();
}
inline bool operator!=(Counted a, Counted b) {
    return a.value() != b.value();
}

inline Counted abs(Counted x) {
    return Counted(std::abs(x.value()));
}
inline Counted min(Counted a, Counted b) {
    return b < a ? b : a;
}
inline Counted max(Counted a, Counted b) {
    return a < b ? b : a;
}
inline Counted clamp(Counted x, Counted low, Counted high) {
    return min(max(x, low), high);
}
inline Counted mix(Counted a, Counted b, Counted t) {
    return a * (Counted(1) - t) + b * t;
}
inline Counted sqrt(Counted x) {
    ++counts().roots;
    return Counted(std::sqrt(x.value()));
}
inline Counted inversesqrt(Counted x) {
    ++counts().roots;
    return Counted(1 / std::sqrt(x.value()));
}
inline Counted exp(Counted x) {
    ++counts().exponentials;
    return Counted(std::exp(x.value()));
}
inline Counted exp2(Counted x) {
    ++counts().exponentials;
    return Counted(std::exp2(x.value()));
}
inline Counted pow(Counted x, Counted y) {
    ++counts().exponentials;
    return Counted(std::pow(x.value(), y.value()));
}

}  // namespace study

template <>
struct std::numeric_limits<study::Counted> : std::numeric_limits<double> {
    static constexpr study::Counted infinity() {
        return study::Counted(std::numeric_limits<double>::infinity());
    }
    static constexpr study::Counted epsilon() {
        return study::Counted(std::numeric_limits<double>::epsilon());
    }
    static constexpr study::Counted max() {
        return study::Counted(std::numeric_limits<double>::max());
    }
    static constexpr study::Counted min() {
        return study::Counted(std::numeric_limits<double>::min());
    }
};

// The headers spell built-ins glm::exp and so on, which is looked up where the header stands: here they are.
namespace glm {
using study::Counted;
using CountedVec3 = vec<3, Counted, defaultp>;

using study::abs;
using study::clamp;
using study::exp;
using study::exp2;
using study::inversesqrt;
using study::max;
using study::min;
using study::mix;
using study::pow;
using study::sqrt;

inline CountedVec3 exp(const CountedVec3& x) {
    return CountedVec3(exp(x.x), exp(x.y), exp(x.z));
}
inline CountedVec3 sqrt(const CountedVec3& x) {
    return CountedVec3(sqrt(x.x), sqrt(x.y), sqrt(x.z));
}
inline CountedVec3 abs(const CountedVec3& x) {
    return CountedVec3(abs(x.x), abs(x.y), abs(x.z));
}
inline CountedVec3 min(const CountedVec3& a, const CountedVec3& b) {
    return CountedVec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z));
}
inline CountedVec3 max(const CountedVec3& a, const CountedVec3& b) {
    return CountedVec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z));
}
inline CountedVec3 min(const CountedVec3& a, Counted b) {
    return min(a, CountedVec3(b, b, b));
}
inline CountedVec3 max(const CountedVec3& a, Counted b) {
    return max(a, CountedVec3(b, b, b));
}
}  // namespace glm
