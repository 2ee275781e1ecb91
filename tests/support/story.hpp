#pragma once

// What a failing test says: function, type, inputs in full precision, expected, got, error.

#include <cstdio>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "ulp.hpp"

namespace airlight_test {

template <typename T>
const char* type_name();
template <>
inline const char* type_name<float>() {
    return "float";
}
template <>
inline const char* type_name<double>() {
    return "double";
}
template <>
inline const char* type_name<long double>() {
    return "long double";
}

/// A number as C prints it exactly (%a) and as people read it.
inline std::string exact(long double x) {
    char text[96];
    std::snprintf(text, sizeof text, "%La (%.21Lg)", x, x);
    return text;
}

/// A number with a few digits, for figures.
inline std::string brief(long double x) {
    char text[48];
    std::snprintf(text, sizeof text, "%.4Lg", x);
    return text;
}

/// One named input of the function under test.
struct Input {
    const char* name;
    long double value;
};

/// One comparison of a function with its expected value, and the words for it.
struct Comparison {
    const char* function;
    const char* type;
    std::vector<Input> inputs;
    long double expected;
    long double got;
    long double error;
    const char* unit;  ///< of `error`: "ulp", "roundoffs x condition", "relative"

    std::string story() const {
        std::string text = std::string(function) + "<" + type + ">";
        for (const Input& input : inputs) {
            text += std::string("\n    ") + input.name + " = " + exact(input.value);
        }
        text += "\n    expected " + exact(expected) + "\n    got      " + exact(got);
        text += "\n    error    " + brief(error) + " " + unit;
        return text;
    }
};

template <typename T>
Comparison compare_ulp(const char* function, std::initializer_list<Input> inputs, T got,
                       long double expected) {
    return Comparison{function, type_name<T>(), inputs, expected, got, ulp_error(got, expected), "ulp"};
}

template <typename T>
Comparison compare_roundoffs(const char* function, std::initializer_list<Input> inputs, T got,
                             long double expected, long double condition) {
    return Comparison{function,
                      type_name<T>(),
                      inputs,
                      expected,
                      got,
                      roundoff_error(got, expected, condition),
                      "roundoffs x condition"};
}

/// |got - expected| / |expected|, for modelling errors; absolute where the expected value is 0.
template <typename T>
Comparison compare_relative(const char* function, std::initializer_list<Input> inputs, T got,
                            long double expected) {
    const long double value = got;
    const long double scale = expected != 0.0L ? std::fabs(expected) : 1.0L;
    const long double error = std::fabs(value - expected) / scale;
    return Comparison{function,  type_name<T>(),
                      inputs,    expected,
                      got,       std::isnan(error) ? std::numeric_limits<long double>::infinity() : error,
                      "relative"};
}

/// Keeps the worst of many comparisons, so that a sweep ends in one check that names its worst input.
class Worst {
  public:
    void add(Comparison comparison) {
        ++count_;
        sum_ += comparison.error;
        if (count_ == 1 || !(comparison.error <= worst_.error)) {
            worst_ = std::move(comparison);
        }
    }

    long double error() const {
        return count_ > 0 ? worst_.error : std::numeric_limits<long double>::infinity();
    }
    long count() const {
        return count_;
    }
    std::string story() const {
        if (count_ == 0) {
            return "nothing was compared";
        }
        return "worst of " + std::to_string(count_) + ": " + worst_.story();
    }

    /// Prints the measured accuracy in one line; docstrings quote this line.
    void print(const char* what) const {
        if (count_ == 0) {
            return;
        }
        std::string text = std::string("accuracy ") + worst_.function + "<" + worst_.type + "> " + what +
                           ": worst " + brief(worst_.error) + ", mean " +
                           brief(sum_ / static_cast<long double>(count_)) + " " + worst_.unit + ", " +
                           std::to_string(count_) + " samples, worst at";
        for (const Input& input : worst_.inputs) {
            text += std::string(" ") + input.name + "=" + brief(input.value);
        }
        std::printf("%s\n", text.c_str());
    }

  private:
    Comparison worst_{};
    long double sum_ = 0.0L;
    long count_ = 0;
};

}  // namespace airlight_test

/// Checks one Comparison against a bound and tells its whole story on failure.
#define CHECK_WITHIN(comparison, bound)                                                 \
    do {                                                                                \
        const airlight_test::Comparison checked_comparison = comparison;                \
        CHECK_MESSAGE(checked_comparison.error <= (bound), checked_comparison.story()); \
    } while (false)

/// Checks the worst of a sweep.
#define CHECK_WORST(worst, bound) CHECK_MESSAGE((worst).error() <= (bound), (worst).story())

/// Checks that a comparison found no difference at all.
#define CHECK_EQUAL(comparison) CHECK_WITHIN(comparison, 0.0L)
