#pragma once

#include <airlight/outward_column.hpp>

namespace airlight {

/// The molecules and the aerosol on a line that first comes closer to the centre, from those on its mirror
/// image, which does not; as if the air never ended.
///
/// Units:    outwards [L], of the mirror image; result [L], without ozone.
/// Domain:   that of LinePoint.
/// Accuracy: that of exponential_from_perigee.
/// Errors:   none; ignores the ground.
/// Source:   exponential_from_perigee.
template <typename T, typename Scene = DefaultScene>
inline Column<T> exponentials_through_perigee(const Layers<T>& layers, const LinePoint<T>& point,
                                              const Column<T>& outwards) {
    const T half_rayleigh =
        exponential_from_perigee(point.perigee_radius, point.perigee_altitude, layers.rayleigh_height);
    T mie = T(0);
    if constexpr (Scene::mie) {
        const T half_mie =
            exponential_from_perigee(point.perigee_radius, point.perigee_altitude, layers.mie_height);
        mie = glm::max(T(2) * half_mie - outwards.mie, T(0));
    }
    return Column<T>{glm::max(T(2) * half_rayleigh - outwards.rayleigh, T(0)), mie, T(0)};
}

/// The molecules and the aerosol from a point to the sun, as if the air never ended.
///
/// Units:    density [1] at the point; result [L], without ozone.
/// Domain:   that of LinePoint; `sinks` where the line first comes closer to the centre.
/// Accuracy: that of exponential_outwards and exponential_from_perigee.
/// Errors:   none; ignores the ground.
/// Source:   exponential_outwards, exponential_from_perigee.
template <typename T, typename Scene = DefaultScene>
inline Column<T> exponentials_to_sun(const Layers<T>& layers, const LinePoint<T>& point, bool sinks,
                                     const Density<T>& density) {
    const T rayleigh =
        exponential_outwards(point, density.rayleigh, layers.rayleigh_height, layers.rayleigh_root);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = exponential_outwards(point, density.mie, layers.mie_height, layers.mie_root);
    }
    const Column<T> outwards = Column<T>{rayleigh, mie, T(0)};
    if (sinks) {
        return exponentials_through_perigee<T, Scene>(layers, point, outwards);
    }
    return outwards;
}

/// The absorbing layer from a point to the sun.
///
/// Units:    ground_radius [L]; result [L].
/// Domain:   that of exponentials_to_sun.
/// Accuracy: that of ozone_beyond.
/// Errors:   none; without an absorbing layer 0; a layer that reaches above the top of the air counts whole.
/// Source:   ozone_beyond.
template <typename T, typename Scene = DefaultScene>
inline T ozone_to_sun(const Layers<T>& layers, T ground_radius, const LinePoint<T>& point, bool sinks) {
    if constexpr (Scene::ozone == ozone_none) {
        return T(0);
    }
    if (!sinks && point.altitude >= layers.ozone.ceiling) {
        return T(0);
    }
    const Shells<T> shells = shells_along<T, Scene>(layers.ozone, ground_radius, point.perigee_altitude);
    return ozone_beyond<T, Scene>(layers.ozone, shells, sinks ? -point.along : point.along);
}

/// The air from a point to the sun.
///
/// The air above the top, were there any, is taken off: for a line that is straight over a scale
/// height, bounded where it grazes the top.
///
/// Units:    density [1] at the point; ground_radius and result [L].
/// Domain:   that of LinePoint; a point inside the air; `sinks` where the line first comes closer to the
///           centre.
/// Accuracy: as light sees it, exp of minus the optical depth: 5e-6 on Earth, in float too (measured:
///           3.3e-6, ozone and a top at 60 km included); ozone of the Lorentz curve by ozone_to_sun.
/// Errors:   none; ignores the ground.
/// Source:   exponentials_to_sun, ozone_to_sun.
template <typename T, typename Scene = DefaultScene>
inline Column<T> column_to_sun(const Layers<T>& layers, T ground_radius, const LinePoint<T>& point,
                               bool sinks, const Density<T>& density) {
    const Column<T> endless = exponentials_to_sun<T, Scene>(layers, point, sinks, density);
    const T square = glm::max(
        (layers.top_radius - point.perigee_radius) * (layers.top_radius + point.perigee_radius), T(0));
    const T slant = T(1) / glm::sqrt(square + T(2) * layers.rayleigh_height * layers.top_radius);
    const T rayleigh = glm::max(endless.rayleigh - layers.rayleigh_above * slant, T(0));
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = glm::max(endless.mie - layers.mie_above * slant, T(0));
    }
    return Column<T>{rayleigh, mie, ozone_to_sun<T, Scene>(layers, ground_radius, point, sinks)};
}

}  // namespace airlight
