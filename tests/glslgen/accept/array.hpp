#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x) {
    const T weight[3] = {T(0.25), T(0.5), T(0.25)};
    T power[3];
    power[0] = T(1);
    power[1] = x;
    power[2] = x * power[1];
    T sum = T(0);
    for (int i = 0; i < 3; ++i) {
        sum += weight[i] * power[i];
    }
    return sum;
}

}  // namespace airlight
