#pragma once

#include <airlight/types.hpp>

namespace airlight {

// A section of its own, above everything.

/// A quantity, with `code` in its text.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
[[nodiscard]] constexpr T f(T x, [[maybe_unused]] T unused) {
    // First the reason,
    // in two lines.
    const T a = x;        // short
    const T longer = a;   // a comment in the column of the one above,
                          // that goes on

    /// Three slashes inside.
    return longer +
           // between two terms
           a;
}

}  // namespace airlight
