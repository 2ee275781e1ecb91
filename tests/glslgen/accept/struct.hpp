#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// The two crossings of a line with a sphere.
template <typename T>
struct RaySphereHit {
    bool hit;  ///< false when the line misses
    T t_near;  ///< [L] the smaller distance;
               ///< negative lies behind the start
    /// [L] the larger distance
    T t_far;
    vec3<T> where;  ///< [L]
    int count;      ///< of crossings
};

/// A struct that holds another.
template <typename T>
struct Pair {
    RaySphereHit<T> first;   ///< one
    RaySphereHit<T> second;  ///< other
};

/// A quantity.
///
/// Units:    none.
/// Domain:   none.
/// Accuracy: none.
/// Errors:   none.
/// Source:   none.
template <typename T>
Pair<T> both(const RaySphereHit<T>& hit, T t) {
    RaySphereHit<T> moved = hit;
    moved.t_near += t;
    moved.where *= T(2);
    return Pair<T>{RaySphereHit<T>{hit.hit, hit.t_near, t, hit.where, 1},
                   moved};
}

}  // namespace airlight
