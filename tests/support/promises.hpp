#pragma once

// What the library promises for every input of its domain, as checks that a test or a fuzzer runs on one
// case: no NaN, no infinity, light >= 0, shares in [0, 1], and the laws that hold whatever the numbers are.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <string>

#include <airlight/airlight.hpp>

#include "story.hpp"

namespace airlight_test {

/// Finite by its bits: with -ffast-math the compiler takes std::isfinite as true.
inline bool is_finite(float x) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7F800000u) != 0x7F800000u;
}
inline bool is_finite(double x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7FF0000000000000u) != 0x7FF0000000000000u;
}
inline bool is_finite(long double x) {
    if constexpr (std::numeric_limits<long double>::digits == 64) {
        std::uint16_t sign_and_exponent = 0;
        std::memcpy(&sign_and_exponent, reinterpret_cast<const char*>(&x) + 8, sizeof sign_and_exponent);
        return (sign_and_exponent & 0x7FFFu) != 0x7FFFu;
    } else {
        return is_finite(static_cast<double>(x));
    }
}

/// Finite and at least 0.
template <typename T>
bool is_amount(T x) {
    return is_finite(x) && x >= T(0);
}
template <typename T>
bool is_amount(const airlight::vec3<T>& v) {
    return is_amount(v.x) && is_amount(v.y) && is_amount(v.z);
}

/// In [0, 1].
template <typename T>
bool is_share(T x) {
    return is_amount(x) && x <= T(1);
}
template <typename T>
bool is_share(const airlight::vec3<T>& v) {
    return is_share(v.x) && is_share(v.y) && is_share(v.z);
}

/// The promises that one case broke, and how near each measured one came to its bound.
class Verdict {
  public:
    void holds(const char* promise, bool kept) {
        ++count_;
        if (!kept) {
            broken_ += std::string("\n    broken: ") + promise;
        }
    }
    /// `error` at most `bound`; NaN breaks the promise.
    template <typename T>
    void within(const char* promise, T error, T bound) {
        ++count_;
        const bool kept = is_finite(error) && error <= bound;
        const long double of_bound = error > T(0) ? static_cast<long double>(error) / bound : 0.0L;
        long double& worst = worst_[promise];
        worst = of_bound > worst ? of_bound : worst;
        if (!kept) {
            broken_ +=
                std::string("\n    broken: ") + promise + ": " + exact(error) + " exceeds " + exact(bound);
        }
    }

    bool kept() const {
        return broken_.empty();
    }
    const std::string& broken() const {
        return broken_;
    }
    /// Takes in another case; keeps the story of the first that broke a promise. `tell` gives its inputs.
    template <typename Tell>
    void add(const Verdict& other, Tell tell) {
        count_ += other.count_;
        if (!other.kept()) {
            ++cases_broken_;
            if (broken_.empty()) {
                broken_ = other.broken_ + tell();
            }
        }
        for (const auto& [promise, of_bound] : other.worst_) {
            long double& worst = worst_[promise];
            worst = of_bound > worst ? of_bound : worst;
        }
    }
    long cases_broken() const {
        return cases_broken_;
    }
    std::string story() const {
        return std::to_string(cases_broken_) + " cases broke a promise, the first:" + broken_;
    }
    /// How many promises were checked, and of the measured ones how near the worst came to its bound.
    void print(const char* what) const {
        std::printf("promises of %s: %ld kept", what, count_ - cases_broken_);
        for (const auto& [promise, of_bound] : worst_) {
            std::printf("; %s to %.2Lg of its bound", promise.c_str(), of_bound);
        }
        std::printf("\n");
    }

  private:
    long count_ = 0;
    long cases_broken_ = 0;
    std::string broken_;
    std::map<std::string, long double> worst_;
};

template <typename T>
std::string told(const char* name, T value) {
    return std::string("\n    ") + name + " = " + exact(value);
}
template <typename T>
std::string told(const char* name, const airlight::vec3<T>& v) {
    const std::string text = name;
    return told((text + ".x").c_str(), v.x) + told((text + ".y").c_str(), v.y) +
           told((text + ".z").c_str(), v.z);
}
template <typename T>
std::string told(const airlight::Atmosphere<T>& air) {
    return std::string("\n    in ") + type_name<T>() + told("ground_radius", air.ground_radius) +
           told("top_altitude", air.top_altitude) + told("rayleigh_scattering", air.rayleigh_scattering) +
           told("rayleigh_scale_height", air.rayleigh_scale_height) +
           told("mie_scattering", air.mie_scattering) + told("mie_absorption", air.mie_absorption) +
           told("mie_scale_height", air.mie_scale_height) + told("mie_g", air.mie_g) +
           told("ozone_absorption", air.ozone_absorption) + told("ozone_altitude", air.ozone_altitude) +
           told("ozone_half_width", air.ozone_half_width);
}

}  // namespace airlight_test
