#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// Hook: the share of sunlight that reaches `position`, in [0, 1].
struct AlwaysLit {
    template <typename T>
    T operator()(const vec3<T>&) const {
        return T(1);
    }
};

}  // namespace airlight
