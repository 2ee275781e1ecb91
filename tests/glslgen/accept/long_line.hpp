#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Five numbers.
template <typename T>
struct Numbers {
    T a;  ///< [1]
    T b;  ///< [1]
    T c;  ///< [1]
    T d;  ///< [1]
    T e;  ///< [1]
};

/// A function with a long name.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T sum_of_three_numbers(T first_number, T second_number, T third_number) {
    return first_number + second_number + third_number;
}

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
Numbers<T> numbers(T x, T first_number, T second_number) {
    const T one_number = x * sum_of_three_numbers(first_number, sum_of_three_numbers(x, x, x), x + second_number);
    return Numbers<T>{first_number + second_number, sum_of_three_numbers(x, first_number, x), one_number,
                      x, x};
}

}  // namespace airlight
