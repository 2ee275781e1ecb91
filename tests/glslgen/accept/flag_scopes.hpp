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

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T, typename Scene = DefaultScene>
T f(T x) {
    T sum = x;
    if constexpr (Scene::mie) {
        const T part = x * x;
        sum += part;
    } else {
        const T part = x + x;
        sum += part;
    }
    if constexpr (Scene::ozone == ozone_tent) {
        const T part = T(3) * x;
        sum += part;
    } else {
        const T rest = T(4) * x;
        sum += rest;
    }
    if constexpr (Scene::mie) { sum += T(1); }
    return sum;
}

}  // namespace airlight
