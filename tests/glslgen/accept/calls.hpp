#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The square.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T square(T x) {
    return x * x;
}

/// Its double, with a local named as a function of ours.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T twice(T x) {
    const T squared = square(x);
    const T long_name_of_a_sum = square<T>(x + squared) +
                                 square<T>(x);
    return airlight::square(T(2)) * squared + long_name_of_a_sum *
                                                  squared;
}

}  // namespace airlight
