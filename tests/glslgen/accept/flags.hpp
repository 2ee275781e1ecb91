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
        sum += T(1);  // aerosol
    }

    if constexpr (Scene::ozone == ozone_tent) {
        // A comment inside.
        sum *= T(2);
    } else if constexpr (Scene::ozone != ozone_none && !Scene::mie) {
        for (int i = 0; i < Scene::steps; ++i) {
            sum += T(i);
            if constexpr (Scene::mie) {
                sum += T(Scene::steps);
            }
        }
    } else {
        sum = T(0);
    }
    return sum;
}

/// Calls with the same scene.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T, typename Scene = DefaultScene>
T g(T x) {
    return f<T, Scene>(x) * x;
}

}  // namespace airlight
