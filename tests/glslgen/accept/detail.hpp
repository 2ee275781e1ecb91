#pragma once

#include <airlight/types.hpp>

namespace airlight {

namespace detail {

/// Half of it; no labels are needed here.
template <typename T>
T half(T x) {
    return T(0.5) * x;
}

}  // namespace detail

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T quarter(T x) {
    return detail::half(detail::half<T>(x));
}

}  // namespace airlight
