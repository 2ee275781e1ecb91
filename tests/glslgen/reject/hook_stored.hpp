#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Hook: the share of sunlight that reaches `position`, in [0, 1].
struct AlwaysLit {
    template <typename T>
    T operator()([[maybe_unused]] const vec3<T>& position) const {
        return T(1);
    }
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T, typename Visibility = AlwaysLit>
T f(const vec3<T>& v, const Visibility& visibility = Visibility{}) {
    const Visibility copy = visibility;
    return copy(v);
}

}  // namespace airlight
