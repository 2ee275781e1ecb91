#pragma once

#include <airlight/column.hpp>

namespace airlight {

/// The thinnest layer that columns are formed for, over the radius of the top of the air [1]; a
/// thinner one, 6 mm on Earth, counts as that.
template <typename T>
inline constexpr T thinnest_layer = T(1e-9L);

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
    vec3<T> ozone_shells;   ///< [L] altitudes of a tent's low end, centre and high end
    vec3<T> ozone_bend;     ///< [1/L] half the curvature of these shells
    T ozone_inverse_width;  ///< [1/L] one over the layer's half width, 0 where there is no layer
};

/// The layers of an atmosphere.
///
/// Units:    lengths in the atmosphere's unit [L].
/// Domain:   that of Atmosphere.
/// Accuracy: 3 ulp; the air above the top 4 roundoffs times top_altitude over the scale height.
/// Errors:   none; a scale height below thinnest_layer counts as that, an ozone layer of zero width as none.
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
    vec3<T> shells = vec3<T>(T(0), T(0), T(0));
    vec3<T> bend = vec3<T>(T(0), T(0), T(0));
    T inverse_width = T(0);
    if constexpr (Scene::ozone != ozone_none) {
        const T centre = atmosphere.ozone_altitude;
        const T width = atmosphere.ozone_half_width;
        shells = vec3<T>(centre - width, centre, centre + width);
        // A shell below the centre holds none of the layer; any curvature will do for it.
        const vec3<T> least = vec3<T>(T(1e-3L), T(1e-3L), T(1e-3L)) * top_radius;
        bend = vec3<T>(T(0.5), T(0.5), T(0.5)) / glm::max(shells + atmosphere.ground_radius, least);
        inverse_width = width > T(0) ? T(1) / width : T(0);
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
                     shells,
                     bend,
                     inverse_width};
}

/// The densities of the exponential layers at an altitude inside the air.
///
/// Units:    altitude [L]; result [1], without ozone.
/// Domain:   altitude >= 0.
/// Accuracy: 3 roundoffs times 1 + altitude over the scale height.
/// Errors:   none.
/// Source:   exponential_density.
template <typename T, typename Scene = DefaultScene>
inline Density<T> layer_density(const Layers<T>& layers, T altitude) {
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
inline LinePoint<T> line_point(T altitude, T radius, T inverse_radius, T along, T perigee_radius,
                               T perigee_altitude) {
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
inline LinePoint<T> line_towards_sun(T altitude, T radius, T inverse_radius, T sun_height) {
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
/// Accuracy: relative 1.3e-4 at radius / height = 50, 3e-5 at 100, 6e-7 from 800 on; below 10 it is lost.
/// Errors:   none.
/// Source:   docs/theory/chapman.md.
template <typename T>
inline T exponential_outwards(const LinePoint<T>& point, T density, T height, T root) {
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

/// Distances of a tent's three shells from a line's closest approach, 0 for those below it.
///
/// Units:    ground_radius and perigee_altitude [L]; result [L].
/// Shape:    the result is one distance for each of layers.ozone_shells.
/// Domain:   ground_radius > 0.
/// Accuracy: 4 roundoffs plus that of the difference of the altitudes.
/// Errors:   none.
/// Source:   difference of squares.
template <typename T>
inline vec3<T> shells_along(const Layers<T>& layers, T ground_radius, T perigee_altitude) {
    const vec3<T> over = layers.ozone_shells - perigee_altitude;
    const vec3<T> sum = layers.ozone_shells + (T(2) * ground_radius + perigee_altitude);
    return glm::sqrt(glm::max(over * sum, vec3<T>(T(0), T(0), T(0))));
}

/// The air of a tent on a line, from a point on.
///
/// A tent is a second difference of ramps. A ramp is how deep the line lies below a shell, integrated
/// from the point, or from where the line enters the shell, to where it leaves it:
///
///     integral (k - h) ds,   k - h = y / 2 r_k + (y / 2 r_k)^2 / 2 r_k + ...,   y = shell_along^2 - s^2
///
/// Units:    shells [L] of shells_along; along [L] of the point from the closest approach, negative where
///           that is still to come; result [L].
/// Domain:   every along.
/// Accuracy: 3e-5 of the largest column through the layer (measured: 2.4e-5 on Earth). In float a tent
///           narrower than a twentieth of its altitude is lost in the roundoff of its ramps.
/// Errors:   none; a layer of zero width gives 0. Below the ground the tent goes on.
/// Source:   series of the shell's radius, integrated term by term.
template <typename T>
inline T tent_beyond(const Layers<T>& layers, const vec3<T>& shells, T along) {
    const vec3<T> from = glm::clamp(vec3<T>(along, along, along), -shells, shells);
    const vec3<T> way = shells - from;
    const vec3<T> bent = way * layers.ozone_bend;
    const T third = T(0.333333333333333333333333333333333333L);
    const vec3<T> order_1 = T(2) * third * way + from;
    const vec3<T> order_2 = way * (T(1.6L) * third * way + T(5) * third * from) + T(4) * third * from * from;
    const vec3<T> ramps = way * bent * (order_1 + bent * layers.ozone_bend * order_2);
    return glm::max(ramps.x - T(2) * ramps.y + ramps.z, T(0)) * layers.ozone_inverse_width;
}

/// The air of a Lorentz curve times the Rayleigh density on a line, from a point outwards.
///
/// Eight points of Gauss over q with y = y_centre + width 2 q / (1 - q^2), y^2 = altitude over the closest
/// approach: y takes the square root away that the closest approach puts in, and q the curve's peak.
///
/// Altitudes are counted from the layer's centre, where they have the most digits.
///
/// Units:    along and altitude [L] of the point, inverse_root [L^-0.5] as in LinePoint; result [L].
/// Domain:   ground_radius > 0.
/// Accuracy: 5e-3 of the largest column through the layer (measured: 4.0e-3 with Leenman's numbers).
/// Errors:   none; a layer of zero width gives 0; what lies more than 10 half widths above the centre is
///           left out.
/// Source:   Gauss-Legendre quadrature.
template <typename T>
inline T lorentzian_outwards(const Atmosphere<T>& atmosphere, const Layers<T>& layers, T perigee_radius,
                             T perigee_altitude, T along, T inverse_root, T altitude) {
    const T centre = atmosphere.ozone_altitude;
    const T width = atmosphere.ozone_half_width;
    const T end = glm::min(atmosphere.top_altitude, centre + T(10) * width);
    if (width <= T(0) || altitude >= end) {
        return T(0);
    }
    const T over = centre - perigee_altitude;
    const T base = glm::max(centre, perigee_altitude);
    const T y_centre = safe_sqrt(over);
    const T spread = over > T(0) ? T(2) * width / (y_centre + glm::sqrt(over + width))
                                 : T(2) * glm::sqrt(glm::sqrt(width * width + over * over));
    const T y_sum = along * inverse_root + y_centre;
    const T end_sum = safe_sqrt(end - perigee_altitude) + y_centre;
    // Nothing worth counting lies further than 1000 widths out; q keeps its digits up to there.
    const T first = y_sum > T(0) ? glm::clamp((altitude - base) / (y_sum * spread), T(-1000), T(1000)) : T(0);
    const T last = end_sum > T(0) ? glm::clamp((end - base) / (end_sum * spread), T(-1000), T(1000)) : T(0);
    const T q_first = first / (T(1) + glm::sqrt(T(1) + first * first));
    const T q_way = glm::max(last / (T(1) + glm::sqrt(T(1) + last * last)) - q_first, T(0));
    T sum = T(0);
    for (int i = 0; i < 8; ++i) {
        const T q = q_first + q_way * gauss_8_positions<T>[i];
        const T stretch = T(1) / ((T(1) - q) * (T(1) + q));
        const T y = T(2) * spread * q * stretch;
        const T over_base = y * (y + T(2) * y_centre);
        const T offset = (over_base + (base - centre)) * layers.ozone_inverse_width;
        const T air = glm::exp(-glm::max(base + over_base, T(0)) * layers.rayleigh_inverse);
        sum += gauss_8_weights<T>[i] * air * (T(1) + q * q) * stretch * stretch / (T(1) + offset * offset);
    }
    const T radius = atmosphere.ground_radius + base;
    return T(4) * spread * q_way * sum * radius / glm::sqrt(radius + perigee_radius);
}

/// The air of a view ray or of a sun ray outwards from a point of it, away from its closest approach; a
/// difference of two is the air between two points.
///
/// Units:    density [1] at the point; shells [L] of shells_along; result [L].
/// Domain:   that of LinePoint.
/// Accuracy: that of exponential_outwards, tent_beyond and lorentzian_outwards.
/// Errors:   none.
/// Source:   exponential_outwards, tent_beyond, lorentzian_outwards.
template <typename T, typename Scene = DefaultScene>
inline Column<T> column_outwards(const Atmosphere<T>& atmosphere, const Layers<T>& layers,
                                 const LinePoint<T>& point, const vec3<T>& shells,
                                 const Density<T>& density) {
    const T rayleigh =
        exponential_outwards(point, density.rayleigh, layers.rayleigh_height, layers.rayleigh_root);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = exponential_outwards(point, density.mie, layers.mie_height, layers.mie_root);
    }
    T ozone = T(0);
    if constexpr (Scene::ozone == ozone_tent) {
        ozone = tent_beyond(layers, shells, point.along);
    }
    if constexpr (Scene::ozone == ozone_lorentzian) {
        ozone = lorentzian_outwards(atmosphere, layers, point.perigee_radius, point.perigee_altitude,
                                    point.along, point.inverse_root, point.altitude);
    }
    return Column<T>{rayleigh, mie, ozone};
}

}  // namespace airlight
