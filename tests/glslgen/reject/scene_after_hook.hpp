#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// No layer.
inline constexpr int ozone_none = 0;
/// A tent.
inline constexpr int ozone_tent = 1;
/// A Lorentz curve.
inline constexpr int ozone_lorentzian = 2;

/// The terms of a scene.
struct DefaultScene {
    static constexpr bool mie = true;         ///< aerosol
    static constexpr int ozone = ozone_tent;  ///< profile of the layer
    static constexpr int steps = 16;          ///< samples
};

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
template <typename T, typename Visibility = AlwaysLit, typename Scene = DefaultScene>
T f(T x, const Visibility& visibility = Visibility{}) {
    return x;
}

}  // namespace airlight
