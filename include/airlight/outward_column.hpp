#pragma once

#include <airlight/ozone_ramps.hpp>

namespace airlight {

/// The layers of an atmosphere as columns along lines need them: what depends on no line and no point.
template <typename T>
struct Layers {
    T rayleigh_height;   ///< [L] scale height of the molecules
    T rayleigh_inverse;  ///< [1/L] one over it
    T rayleigh_root;     ///< [L^-0.5] one over its root
    T mie_height;        ///< [L] scale height of the aerosol
    T mie_inverse;       ///< [1/L] one over it
    T mie_root;          ///< [L^-0.5] one over its root
    T top_radius;        ///< [L] where the air ends
    T rayleigh_above;    ///< [L^2] molecules that a vertical line would meet above the top, times top_radius
    T mie_above;         ///< [L^2] aerosol, the same
    Ramps<T> ozone;      ///< the absorbing layer
};

/// The layers of an atmosphere.
///
/// Units:    lengths in the atmosphere's unit [L].
/// Domain:   that of Atmosphere.
/// Accuracy: 3 ulp; the air above the top 4 roundoffs times top_altitude over the scale height.
/// Errors:   none; a scale height below thinnest_layer counts as that.
/// Source:   none.
template <typename T, typename Scene = DefaultScene>
inline Layers<T> layers_of(const Atmosphere<T>& atmosphere) {
    const T top_radius = atmosphere.ground_radius + atmosphere.top_altitude;
    const T thinnest = thinnest_layer<T> * top_radius;
    const T rayleigh_height = glm::max(atmosphere.rayleigh_scale_height, thinnest);
    const T rayleigh_above =
        top_radius * rayleigh_height * glm::exp(-atmosphere.top_altitude / rayleigh_height);
    T mie_height = thinnest;
    T mie_above = T(0);
    if constexpr (Scene::mie) {
        mie_height = glm::max(atmosphere.mie_scale_height, thinnest);
        mie_above = top_radius * mie_height * glm::exp(-atmosphere.top_altitude / mie_height);
    }
    return Layers<T>{rayleigh_height,
                     T(1) / rayleigh_height,
                     T(1) / glm::sqrt(rayleigh_height),
                     mie_height,
                     T(1) / mie_height,
                     T(1) / glm::sqrt(mie_height),
                     top_radius,
                     rayleigh_above,
                     mie_above,
                     ozone_ramps<T, Scene>(atmosphere)};
}

/// The densities of the exponential layers at an altitude inside the air.
///
/// Units:    altitude [L]; result [1], without ozone.
/// Domain:   altitude >= 0.
/// Accuracy: 3 roundoffs times 1 + altitude over the scale height.
/// Errors:   none.
/// Source:   exponential_density.
template <typename T, typename Scene = DefaultScene>
[[gnu::always_inline]] inline Density<T> layer_density(const Layers<T>& layers, T altitude) {
    const T rayleigh = glm::exp(-altitude * layers.rayleigh_inverse);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = glm::exp(-altitude * layers.mie_inverse);
    }
    return Density<T>{rayleigh, mie, T(0)};
}

/// A point on a straight line through the air, with the line's closest approach to the centre.
template <typename T>
struct LinePoint {
    T altitude;          ///< [L] of the point
    T radius;            ///< [L] of the point, from the centre
    T along;             ///< [L] from the closest approach to the point, never negative
    T perigee_radius;    ///< [L] of the closest approach
    T perigee_altitude;  ///< [L] the same, above the ground sphere
    T inverse_root;      ///< [L^-0.5] 1 / sqrt(radius + perigee_radius)
    T bend;              ///< [1/L] (1/2 + perigee_radius / radius) / (radius + perigee_radius)
};

/// A point on a line whose closest approach is known.
///
/// Units:    altitude, radius, along, perigee_radius and perigee_altitude [L], inverse_radius [1/L].
/// Domain:   radius > 0.
/// Accuracy: 6 ulp.
/// Errors:   none.
/// Source:   none.
template <typename T>
[[gnu::always_inline]] inline LinePoint<T> line_point(T altitude, T radius, T inverse_radius, T along,
                                                      T perigee_radius, T perigee_altitude) {
    const T inverse_root = T(1) / glm::sqrt(radius + perigee_radius);
    const T bend = inverse_root * inverse_root * (T(0.5) + perigee_radius * inverse_radius);
    return LinePoint<T>{altitude, radius, along, perigee_radius, perigee_altitude, inverse_root, bend};
}

/// The line from a point towards the sun.
///
/// Units:    altitude and radius [L] of the point, inverse_radius [1/L]; sun_height [L], of the point from
///           the centre towards the sun; lengths of the result [L].
/// Domain:   |sun_height| at most the radius, rounding past it is forgiven.
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   differences of squares, docs/theory/altitude.md.
template <typename T>
[[gnu::always_inline]] inline LinePoint<T> line_towards_sun(T altitude, T radius, T inverse_radius,
                                                            T sun_height) {
    const T along = glm::min(glm::abs(sun_height), radius);
    const T perigee_radius = glm::sqrt((radius - along) * (radius + along));
    LinePoint<T> point = line_point(altitude, radius, inverse_radius, along, perigee_radius, altitude);
    const T depth = along * point.inverse_root;
    point.perigee_altitude = altitude - depth * depth;
    return point;
}

/// The air of an exponential layer on a line, from a point away from the closest approach, for ever.
///
///     density height radius reach (E(w) + height bend (w + E(w) (1/2 - w^2))),
///     reach = 1 / sqrt((radius + perigee_radius) height),   w = along reach
///
/// Chapman's function to first order.
///
/// Units:    density [1] at the point; height [L], root [L^-0.5] as in Layers; result [L].
/// Domain:   height >= thinnest_layer of the air; point.radius > 0.
/// Accuracy: relative 1.3e-4 at radius / height = 50, 3.3e-5 at 100, 6e-7 from 800 on; below 10 it is lost.
/// Errors:   none.
/// Source:   docs/theory/chapman.md.
template <typename T>
[[gnu::always_inline]] inline T exponential_outwards(const LinePoint<T>& point, T density, T height, T root) {
    const T reach = point.inverse_root * root;
    const T w = point.along * reach;
    const T order_0 = scaled_erfc(w);
    const T order_1 = w + order_0 * (T(0.5) - w * w);
    return density * height * (point.radius * reach) * (order_0 + height * point.bend * order_1);
}

/// The air of an exponential layer on a line, from its closest approach outwards, for ever.
///
///     height rho_p sqrt(pi / 2 (x + 3 / 4)),   x = perigee_radius / height
///
/// Units:    perigee_radius, perigee_altitude and height [L]; result [L].
/// Domain:   height > 0; perigee_radius >= 0.
/// Accuracy: relative 2e-5 at x = 50, 1e-7 from 800 on.
/// Errors:   none; below the ground the density grows, to e^40.
/// Source:   docs/theory/chapman.md.
template <typename T>
inline T exponential_from_perigee(T perigee_radius, T perigee_altitude, T height) {
    const T density = glm::exp(glm::min(-perigee_altitude / height, T(40)));
    return density * glm::sqrt(T(0.5) * pi<T> * height * (perigee_radius + T(0.75) * height));
}

/// The air of a view ray or of a sun ray outwards from a point of it, away from its closest approach; a
/// difference of two is the air between two points.
///
/// Units:    density [1] at the point; shells of shells_along; result [L].
/// Domain:   that of LinePoint.
/// Accuracy: that of exponential_outwards and ozone_beyond.
/// Errors:   none.
/// Source:   exponential_outwards, ozone_beyond.
template <typename T, typename Scene = DefaultScene>
inline Column<T> column_outwards(const Layers<T>& layers, const LinePoint<T>& point, const Shells<T>& shells,
                                 const Density<T>& density) {
    const T rayleigh =
        exponential_outwards(point, density.rayleigh, layers.rayleigh_height, layers.rayleigh_root);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = exponential_outwards(point, density.mie, layers.mie_height, layers.mie_root);
    }
    return Column<T>{rayleigh, mie, ozone_beyond<T, Scene>(layers.ozone, shells, point.along)};
}

}  // namespace airlight
