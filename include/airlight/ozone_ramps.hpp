#pragma once

#include <airlight/column.hpp>

namespace airlight {

/// The thinnest layer that columns are formed for, over the radius of the top of the air [1]; a
/// thinner one, 6 mm on Earth, counts as that.
template <typename T>
inline constexpr T thinnest_layer = T(1e-9L);

/// Twelve numbers, one for each shell of an absorbing layer. A tent has three shells, all in `first`.
template <typename T>
struct Shells {
    vec3<T> first;   ///< shells 1 to 3, from below
    vec3<T> second;  ///< shells 4 to 6
    vec3<T> third;   ///< shells 7 to 9
    vec3<T> fourth;  ///< shells 10 to 12
};

/// An absorbing layer as a sum of ramps:
///
///     density(r) = sum weights_k max(r_k^2 - r^2, 0)
///
/// Between two shells r_k the density is a straight line in r^2, so that a straight ray meets a polynomial.
template <typename T>
struct Ramps {
    Shells<T> altitudes;  ///< [L] of the shells
    Shells<T> weights;    ///< [1/L^2] by how much the slope bends at each
    T edge;               ///< [L] altitude where most of the layer ends: one half width above its centre
    T ceiling;            ///< [L] altitude of the last shell: the layer has ended
};

/// The slopes of a layer between shells, per square of the radius.
///
/// Units:    low and high, altitudes of the shells below and above [L], ground_radius [L]; low_density and
///           high_density [1]; result [1/L^2].
/// Shape:    three spans at once.
/// Domain:   low <= high.
/// Accuracy: 4 roundoffs plus those of high - low.
/// Errors:   none; two shells closer than thinnest_layer count as that far apart.
/// Source:   divided difference.
template <typename T>
inline vec3<T> span_slopes(T ground_radius, const vec3<T>& low, const vec3<T>& high,
                           const vec3<T>& low_density, const vec3<T>& high_density) {
    const T thinnest = thinnest_layer<T> * ground_radius;
    const vec3<T> span = glm::max(high - low, vec3<T>(thinnest, thinnest, thinnest));
    const vec3<T> sum = glm::max(T(2) * ground_radius + low + high, vec3<T>(thinnest, thinnest, thinnest));
    return (high_density - low_density) / (span * sum);
}

/// A tent as ramps. Between its shells it is straight in r^2, not in r.
///
/// Units:    those of Ramps.
/// Domain:   that of Atmosphere.
/// Accuracy: 4e-5 of the largest column through the layer on Earth (measured: 3.8e-5); the density to half
///           width over 12 radii of its peak.
/// Errors:   none; a tent of zero width gives zero weights; what would lie below the centre is left out.
/// Source:   docs/theory/nodes.md.
template <typename T>
inline Ramps<T> tent_ramps(const Atmosphere<T>& atmosphere) {
    const T radius = atmosphere.ground_radius;
    const T centre = atmosphere.ozone_altitude;
    const T width = atmosphere.ozone_half_width;
    const vec3<T> none = vec3<T>(T(0), T(0), T(0));
    // Straight in r^2 bends the tent's two sides the same way; moved down by the mean of it, both are right
    // on the average.
    const T bend = glm::min(width, radius + centre) / (T(12) * (radius + centre));
    const T peak_at = glm::max(centre - bend * width, -radius);
    const vec3<T> at = vec3<T>(glm::max(peak_at - width, -radius), peak_at, peak_at + width);
    const T peak = width > T(0) ? T(1) : T(0);
    const vec3<T> slopes = span_slopes(radius, at, vec3<T>(at.y, at.z, at.z), vec3<T>(T(0), peak, T(0)),
                                       vec3<T>(peak, T(0), T(0)));
    const vec3<T> weights = slopes - vec3<T>(T(0), slopes.x, slopes.y);
    return Ramps<T>{Shells<T>{at, none, none, none}, Shells<T>{weights, none, none, none}, at.z, at.z};
}

/// Three shells of a Lorentz curve times the Rayleigh density, each in proportion to the curve.
///
/// Units:    altitude [L] of the shells, share [1]; result [1].
/// Domain:   ozone_half_width > 0, rayleigh_height > 0.
/// Accuracy: 4 roundoffs times 1 + altitude over the scale height.
/// Errors:   none.
/// Source:   lorentzian_density, exponential_density.
template <typename T>
vec3<T> lorentzian_at(const Atmosphere<T>& atmosphere, T rayleigh_height, const vec3<T>& altitude,
                      const vec3<T>& share) {
    const vec3<T> offset = (altitude - atmosphere.ozone_altitude) / atmosphere.ozone_half_width;
    return share * glm::exp(-altitude / rayleigh_height) / (T(1) + offset * offset);
}

/// A Lorentz curve times the Rayleigh density as ramps.
///
/// Twelve shells, in half widths from the centre, and the share of the curve's density that each gets, are
/// fitted to the columns of Leenman's layer, and with less weight of four like it. The first shell is at the
/// ground or below it.
///
/// Units:    those of Ramps.
/// Domain:   that of Atmosphere.
/// Accuracy: 5e-3 of the level column just below the curve's peak (measured: 4.3e-3 with Leenman's numbers);
///           2e-2 for curves like it, 8e-2 where it is wider or higher than a few Rayleigh scale heights.
/// Errors:   none; a layer of zero width gives zero weights; a curve much narrower than an eighth of its
///           altitude counts up to a tenth of its largest column too much.
/// Source:   study/fit_ozone.py.
template <typename T>
Ramps<T> lorentzian_ramps(const Atmosphere<T>& atmosphere) {
    const T radius = atmosphere.ground_radius;
    const T width = atmosphere.ozone_half_width;
    const T height =
        glm::max(atmosphere.rayleigh_scale_height, thinnest_layer<T> * (radius + atmosphere.top_altitude));
    // Six scale heights up hardly any molecules are left: what there is of the product lies below its peak.
    const T centre = glm::min(atmosphere.ozone_altitude, T(6) * height);
    // A wide curve is mostly the molecules' exponential: its shells lie where those are.
    const T spread = glm::min(width, glm::max(centre / T(7.99L), T(0.7L) * height));
    vec3<T> at_1 = centre + spread * vec3<T>(T(-7.99L), T(-6.01L), T(-4.35L));
    const vec3<T> at_2 = centre + spread * vec3<T>(T(-2.55L), T(-1.47L), T(-0.39L));
    const vec3<T> at_3 = centre + spread * vec3<T>(T(-0.01L), T(0.56L), T(0.98L));
    const vec3<T> at_4 = centre + spread * vec3<T>(T(1.6L), T(2.63L), T(5.29L));
    at_1.x = glm::min(at_1.x, T(0));
    const Shells<T> at = Shells<T>{at_1, at_2, at_3, at_4};
    const vec3<T> none = vec3<T>(T(0), T(0), T(0));
    if (width <= T(0)) {
        return Ramps<T>{at, Shells<T>{none, none, none, none}, centre, centre};
    }
    const vec3<T> n_1 = lorentzian_at(atmosphere, height, at_1, vec3<T>(T(0.959L), T(0.983L), T(0.969L)));
    const vec3<T> n_2 = lorentzian_at(atmosphere, height, at_2, vec3<T>(T(0.96L), T(0.977L), T(1.015L)));
    const vec3<T> n_3 = lorentzian_at(atmosphere, height, at_3, vec3<T>(T(1.024L), T(1.001L), T(0.945L)));
    const vec3<T> n_4 = lorentzian_at(atmosphere, height, at_4, vec3<T>(T(0.903L), T(0.727L), T(0)));
    const vec3<T> m_1 =
        span_slopes(radius, at_1, vec3<T>(at_1.y, at_1.z, at_2.x), n_1, vec3<T>(n_1.y, n_1.z, n_2.x));
    const vec3<T> m_2 =
        span_slopes(radius, at_2, vec3<T>(at_2.y, at_2.z, at_3.x), n_2, vec3<T>(n_2.y, n_2.z, n_3.x));
    const vec3<T> m_3 =
        span_slopes(radius, at_3, vec3<T>(at_3.y, at_3.z, at_4.x), n_3, vec3<T>(n_3.y, n_3.z, n_4.x));
    const vec3<T> m_4 =
        span_slopes(radius, at_4, vec3<T>(at_4.y, at_4.z, at_4.z), n_4, vec3<T>(n_4.y, n_4.z, n_4.z));
    const Shells<T> weights =
        Shells<T>{m_1 - vec3<T>(T(0), m_1.x, m_1.y), m_2 - vec3<T>(m_1.z, m_2.x, m_2.y),
                  m_3 - vec3<T>(m_2.z, m_3.x, m_3.y), m_4 - vec3<T>(m_3.z, m_4.x, m_4.y)};
    return Ramps<T>{at, weights, atmosphere.ozone_altitude + width, at_4.z};
}

/// The absorbing layer of the scene as ramps.
///
/// Units:    those of Ramps.
/// Domain:   that of Atmosphere.
/// Accuracy: that of tent_ramps and lorentzian_ramps.
/// Errors:   none; a scene without absorbing layer gets zero weights.
/// Source:   tent_ramps, lorentzian_ramps.
template <typename T, typename Scene = DefaultScene>
inline Ramps<T> ozone_ramps(const Atmosphere<T>& atmosphere) {
    if constexpr (Scene::ozone == ozone_tent) {
        return tent_ramps(atmosphere);
    } else if constexpr (Scene::ozone == ozone_lorentzian) {
        return lorentzian_ramps(atmosphere);
    } else {
        const vec3<T> none = vec3<T>(T(0), T(0), T(0));
        const Shells<T> zeros = Shells<T>{none, none, none, none};
        return Ramps<T>{zeros, zeros, T(0), T(0)};
    }
}

/// Distances from a line's closest approach to the centre to where it crosses three shells, 0 for shells
/// below it.
///
/// Units:    altitudes of the shells, ground_radius and perigee_altitude [L]; result [L].
/// Domain:   ground_radius > 0.
/// Accuracy: 4 roundoffs plus that of the difference of the altitudes.
/// Errors:   none.
/// Source:   difference of squares.
template <typename T>
inline vec3<T> crossings(const vec3<T>& altitudes, T ground_radius, T perigee_altitude) {
    const vec3<T> over = altitudes - perigee_altitude;
    const vec3<T> sum = altitudes + (T(2) * ground_radius + perigee_altitude);
    return glm::sqrt(glm::max(over * sum, vec3<T>(T(0), T(0), T(0))));
}

/// crossings for all shells of the absorbing layer.
///
/// Units:    those of crossings.
/// Domain:   that of crossings.
/// Accuracy: that of crossings.
/// Errors:   none; shells that the scene does not have give 0.
/// Source:   crossings.
template <typename T, typename Scene = DefaultScene>
inline Shells<T> shells_along(const Ramps<T>& ramps, T ground_radius, T perigee_altitude) {
    const Shells<T> at = ramps.altitudes;
    const vec3<T> none = vec3<T>(T(0), T(0), T(0));
    if constexpr (Scene::ozone == ozone_tent) {
        return Shells<T>{crossings(at.first, ground_radius, perigee_altitude), none, none, none};
    } else if constexpr (Scene::ozone == ozone_lorentzian) {
        return Shells<T>{crossings(at.first, ground_radius, perigee_altitude),
                         crossings(at.second, ground_radius, perigee_altitude),
                         crossings(at.third, ground_radius, perigee_altitude),
                         crossings(at.fourth, ground_radius, perigee_altitude)};
    } else {
        return Shells<T>{none, none, none, none};
    }
}

/// Three ramps on a line, from a point on. Where `a` is the distance of a shell from the closest approach and
/// `way` what is left of the line inside it:
///
///     integral (a^2 - s^2) ds = way^2 (a - way / 3)
///
/// Units:    weights [1/L^2]; shells, of crossings [L]; along [L] of the point from the closest approach,
///           negative where that is still to come; result [L].
/// Domain:   every along.
/// Accuracy: 4 roundoffs of the largest ramp.
/// Errors:   none.
/// Source:   integrated here.
template <typename T>
[[gnu::always_inline]] inline T ramps_beyond(const vec3<T>& weights, const vec3<T>& shells, T along) {
    const vec3<T> way = shells - glm::clamp(vec3<T>(along, along, along), -shells, shells);
    const T third = T(0.333333333333333333333333333333333333L);
    return dot_product(weights * way, way * (shells - third * way));
}

/// The air of the absorbing layer on a line, from a point on.
///
/// Units:    shells [L] of shells_along; along [L] of the point from the closest approach, negative where
///           that is still to come; result [L].
/// Domain:   every along.
/// Accuracy: that of tent_ramps and lorentzian_ramps. In float a layer narrower than a twentieth of its
///           altitude is lost in the roundoff of its ramps.
/// Errors:   none; a layer of zero width gives 0. Below the ground the layer goes on.
/// Source:   ramps_beyond.
template <typename T, typename Scene = DefaultScene>
inline T ozone_beyond(const Ramps<T>& ramps, const Shells<T>& shells, T along) {
    T air = T(0);
    if constexpr (Scene::ozone != ozone_none) {
        air = ramps_beyond(ramps.weights.first, shells.first, along);
    }
    if constexpr (Scene::ozone == ozone_lorentzian) {
        air += ramps_beyond(ramps.weights.second, shells.second, along);
        air += ramps_beyond(ramps.weights.third, shells.third, along);
        air += ramps_beyond(ramps.weights.fourth, shells.fourth, along);
    }
    return glm::max(air, T(0));
}

}  // namespace airlight
