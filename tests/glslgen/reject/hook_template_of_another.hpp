#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The terms of a scene.
struct DefaultScene {
    static constexpr bool mie = true;  ///< aerosol
};

/// A layer.
template <typename T>
struct Layer {
    T strength;  ///< [1]
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T, typename Scene = DefaultScene>
T strength_at(const Layer<T>& layer, T altitude) {
    T result = layer.strength * altitude;
    if constexpr (Scene::mie) {
        result = T(2) * result;
    }
    return result;
}

/// Hook: the strength of the layer at an altitude; a macro sees the caller's `layer`.
template <typename Other>
struct ComputedStrength {
    template <typename T>
    T operator()(const Layer<T>& layer, T altitude) const {
        return strength_at<T, Other>(layer, altitude);
    }
};

}  // namespace airlight
