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
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
T lit_length(const vec3<T>& origin, const vec3<T>& direction, T length,
             const Visibility& visibility = Visibility{}) {
    const T step_length = length / T(Scene::steps);
    T lit_length = T(0);
    for (int i = 0; i < Scene::steps; ++i) {
        const vec3<T> position = origin + (T(i) + T(0.5)) * step_length * direction;
        lit_length += step_length * visibility(position);
    }
    return lit_length;
}

/// Passes the hook on.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
T dark_length(const vec3<T>& origin, const vec3<T>& direction, T length,
              const Visibility& visibility = Visibility{}) {
    return length - lit_length<T, Scene>(origin, direction, length, visibility);
}

}  // namespace airlight
