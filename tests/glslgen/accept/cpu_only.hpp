#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Reads a file. AIRLIGHT_CPU_ONLY
inline double on_the_cpu(const char* name) { return name ? 1.0 : 2.0; }

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
T f(T x) {
    return x;
}

}  // namespace airlight
