#pragma once

#include <airlight/scene.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// What counts as 0 in a ratio that must not divide by it: of a piece too short for T's digits [1].
template <typename T>
inline constexpr T smallest_share = T(1e-20L);

/// Numbers that shape node_map, fitted for a count of nodes [1].
template <typename T>
struct NodeFit {
    T evenness;  ///< how far from the closest approach the altitude starts to be linear in v
    T heights;   ///< how many heights of the air the nodes spread over
    T pull;      ///< how strongly an optical depth draws the nodes to the side where the light is
    T sun;       ///< weight of the sun's optical depth in that
    T view;      ///< weight of the view's optical depth in that
};

/// The fit for the scene's count of nodes.
///
/// Units:    result [1].
/// Domain:   none, it takes no argument.
/// Accuracy: three digits; the error of single_scattering changes little around the best values.
/// Errors:   none.
/// Source:   the simplex of Nelder and Mead on views of the study's atmospheres; study/fit_nodes goes on
///           from here.
template <typename T, typename Scene = DefaultScene>
NodeFit<T> node_fit() {
    if constexpr (Scene::nodes < 5) {
        return NodeFit<T>{T(0.532L), T(1.797L), T(0.3122L), T(0.468L), T(0.933L)};
    } else if constexpr (Scene::nodes < 6) {
        return NodeFit<T>{T(0.44L), T(1.067L), T(0.1556L), T(0.9L), T(0.928L)};
    } else if constexpr (Scene::nodes < 7) {
        return NodeFit<T>{T(0.508L), T(1.341L), T(0.2887L), T(0.698L), T(0.834L)};
    } else if constexpr (Scene::nodes < 9) {
        return NodeFit<T>{T(0.743L), T(2.632L), T(0.0706L), T(0.535L), T(0.608L)};
    } else if constexpr (Scene::nodes < 11) {
        return NodeFit<T>{T(0.678L), T(2.169L), T(0.0201L), T(2.288L), T(2.808L)};
    } else if constexpr (Scene::nodes < 13) {
        return NodeFit<T>{T(0.853L), T(3.739L), T(0.0879L), T(0.223L), T(2.348L)};
    } else if constexpr (Scene::nodes < 17) {
        return NodeFit<T>{T(0.773L), T(2.018L), T(0.1269L), T(0.44L), T(1.479L)};
    } else {
        return NodeFit<T>{T(0.896L), T(4.948L), T(0.1336L), T(0.366L), T(1.242L)};
    }
}

/// How the nodes of one piece of a ray spread between its lowest and its highest point. The piece lies on
/// one side of the closest approach, so it climbs from the one to the other.
template <typename T>
struct NodeMap {
    T low_radius;  ///< [L] of the lowest point
    T low_along;   ///< [L] of the lowest point, from the closest approach
    T scale;       ///< [L] of altitude per unit of the map
    T linear;      ///< [1] share of the altitude that grows with v, the rest with v^2
    T bend;        ///< [1] in [0, 1), how much denser the nodes are at the low end
    T pull;        ///< [1] greater than 1 draws the nodes to the high end
};

/// The map for one piece.
///
///     height over the low end = scale v (linear + (1 - linear) v) / (1 - bend v),   v = pull u / (1 - u +
///     pull u)
///
/// Near the closest approach altitude grows with the square of the distance, elsewhere linearly; the
/// density falls by e per height; light is lost towards the sun and towards the eye. The map gives
/// each its due with fractions alone, so no piece is too short or too thick for it.
///
/// Units:    low_radius, low_along, high_radius, rise and height [L]; pulled [1], the optical depth
///           that draws nodes upwards, negative for downwards.
/// Domain:   low_along >= 0; rise >= 0, the altitude of the high end over the low one; height > 0.
/// Accuracy: none, every map is a change of variable and exact.
/// Errors:   none.
/// Source:   Gauss-Legendre quadrature after a change of variable; docs/theory/nodes.md.
template <typename T>
inline NodeMap<T> node_map(const NodeFit<T>& fit, T low_radius, T low_along, T high_radius, T rise, T height,
                           T pulled) {
    const T heights = rise / height;
    const T start = low_along / glm::sqrt(height * (low_radius + high_radius));
    const T linear =
        start / glm::max(start + fit.evenness * glm::sqrt(heights / (T(1) + heights)), smallest_share<T>);
    const T bend = heights / (heights + fit.heights);
    const T pull = (T(1) + fit.pull * glm::max(pulled, T(0))) / (T(1) + fit.pull * glm::max(-pulled, T(0)));
    const T scale = rise * fit.heights / (heights + fit.heights);
    return NodeMap<T>{low_radius, low_along, scale, linear, bend, pull};
}

/// One sample of a piece.
template <typename T>
struct Node {
    T rise;     ///< [L] altitude over the piece's low end
    T along;    ///< [L] distance from the closest approach
    T way;      ///< [L] from the low end along the ray
    T stretch;  ///< [L] length of ray per unit of u
};

/// The sample at u of a piece.
///
/// Units:    u [1].
/// Domain:   u in (0, 1), 0 at the low end.
/// Accuracy: 20 roundoffs.
/// Errors:   none.
/// Source:   node_map, and its exact derivative.
template <typename T>
[[gnu::always_inline]] inline Node<T> node_at(const NodeMap<T>& map, T u) {
    const T v_share = T(1) / (T(1) - u + map.pull * u);
    const T v = map.pull * u * v_share;
    const T rise_share = T(1) / (T(1) - map.bend * v);
    const T curved = (T(1) - map.linear) * v;
    const T slope = map.linear + curved;
    const T rise = map.scale * v * slope * rise_share;
    const T rise_per_v = map.scale * rise_share * (slope + curved + map.bend * v * slope * rise_share);
    const T square = rise * (T(2) * map.low_radius + rise);
    // Never 0, not even where the rise is too small for T.
    const T along =
        glm::max(glm::sqrt(map.low_along * map.low_along + square), smallest_share<T> * map.low_radius);
    return Node<T>{rise, along, square / (along + map.low_along),
                   (map.low_radius + rise) / along * rise_per_v * (map.pull * v_share * v_share)};
}

}  // namespace airlight
