#pragma once

#include <airlight/constants.hpp>
#include <airlight/dawson.hpp>
#include <airlight/gauss.hpp>
#include <airlight/numeric.hpp>

namespace airlight {

/// The air of a habitat: a cylinder about the x axis that spins, and presses its air to the wall. Without
/// spin the air is even, and the same structure is a fog without walls.
template <typename T>
struct HabitatAir {
    T radius;        ///< [L] from the axis to the wall, where the coefficients hold
    T density_rise;  ///< [1/L^2] of the density's logarithm over the square of the way from the axis
    vec3<T> rayleigh_scattering;  ///< [1/L] at the wall
    vec3<T> mie_scattering;       ///< [1/L] at the wall
    vec3<T> mie_absorption;       ///< [1/L] at the wall
    T mie_g;                      ///< [1] parameter of the aerosol's phase function, see mie_phase
};

/// Where a line is between the wall and the caps of a cylinder about the x axis.
template <typename T>
struct CylinderHit {
    bool hit;  ///< false when the line misses; both distances are then 0
    T t_near;  ///< [L] where it comes in; negative lies behind the start
    T t_far;   ///< [L] where it goes out
};

/// How fast air gets denser away from the axis of a spin.
///
///     d ln(density) / d r^2 = omega^2 / (2 R_s T),   from dp / dr = density omega^2 r and p = density R_s T
///
/// Units:    spin [rad/s]; gas_constant of the mixture [J/(kg K)], 287.05 for dry air; temperature [K], the
///           same everywhere; result [1/m^2].
/// Domain:   gas_constant and temperature > 0.
/// Accuracy: 4 ulp.
/// Errors:   a temperature of 0 divides by zero.
/// Source:   docs/theory/habitat.md.
template <typename T>
T spun_density_rise(T spin, T gas_constant, T temperature) {
    return spin * spin / (T(2) * gas_constant * temperature);
}

/// Spin at which the wall of a habitat weighs as much as a planet's ground: sqrt(gravity / radius).
///
/// Units:    radius [m]; gravity [m/s^2]; result [rad/s].
/// Domain:   radius > 0; gravity >= 0.
/// Accuracy: 2 ulp.
/// Errors:   a radius of 0 divides by zero.
/// Source:   centripetal acceleration.
template <typename T>
T spin_for_gravity(T radius, T gravity) {
    return glm::sqrt(gravity / radius);
}

/// Logarithm of the density relative to the wall's.
///
/// Units:    position [L] from the middle of the axis; result [1].
/// Domain:   every position; the air goes on behind the wall, never denser than exp(40) times the wall's.
/// Accuracy: 4 roundoffs of density_rise radius^2.
/// Errors:   none.
/// Source:   docs/theory/habitat.md.
template <typename T>
T habitat_log_density(const HabitatAir<T>& air, const vec3<T>& position) {
    const T from_axis2 = position.y * position.y + position.z * position.z;
    return glm::min(air.density_rise * (from_axis2 - air.radius * air.radius), T(40));
}

/// Density relative to the wall's.
///
/// Units:    position [L]; result [1].
/// Domain:   that of habitat_log_density.
/// Accuracy: relative as habitat_log_density is absolute, plus exp's own.
/// Errors:   none.
/// Source:   docs/theory/habitat.md.
template <typename T>
T habitat_density(const HabitatAir<T>& air, const vec3<T>& position) {
    return glm::exp(habitat_log_density(air, position));
}

/// Mean of exp(middle + bend (z^2 - 1) + slope z) over z from -1 to 1, for mild slopes and bends.
///
/// Units:    all [1].
/// Domain:   |slope| <= 0.5, bend from 0 to 0.25.
/// Accuracy: 6e-8, plus 8 roundoffs.
/// Errors:   none.
/// Source:   rule of Gauss and Legendre with 5 points.
template <typename T>
T mean_of_mild_rise(T middle, T slope, T bend) {
    T sum = T(0);
    for (int i = 0; i < 5; ++i) {
        const T z = T(2) * gauss_5_positions<T>[i] - T(1);
        sum += gauss_5_weights<T>[i] * glm::exp(middle + z * (slope + bend * z));
    }
    return sum;
}

/// Column of air between two points: the integral of the density relative to the wall's.
///
///     |to - from| / (2 h) (density(to) D(k / (2 h) + h) - density(from) D(k / (2 h) - h))
///
/// with D Dawson's integral, h^2 = density_rise |to - from|^2 / 4 across the axis, and k half the difference
/// of the density's logarithms. Where k and h are below a half the two terms nearly cancel, and five points
/// see all there is.
///
/// Units:    from and to [L]; result [L].
/// Domain:   points in the cylinder, or not far behind its wall; density_rise >= 0.
/// Accuracy: relative 3e-7, plus 24 roundoffs and 8 of density_rise radius^2.
/// Errors:   0 between a point and itself; where the density is at its limit finite, and wrong.
/// Source:   docs/theory/habitat.md.
template <typename T>
T habitat_column(const HabitatAir<T>& air, const vec3<T>& from, const vec3<T>& to) {
    const vec3<T> way = to - from;
    const T way_length = glm::sqrt(dot_product(way, way));
    const T begin = habitat_log_density(air, from);
    const T end = habitat_log_density(air, to);
    // Half the difference, without the cancellation of end - begin.
    const T slope = T(0.5) * air.density_rise * (way.y * (from.y + to.y) + way.z * (from.z + to.z));
    const T bend = T(0.25) * air.density_rise * (way.y * way.y + way.z * way.z);
    if (glm::abs(slope) < T(0.5) && bend < T(0.25)) {
        return way_length * mean_of_mild_rise(T(0.5) * (begin + end) - bend, slope, bend);
    }
    const T h = glm::sqrt(bend);
    const T middle = slope / (T(2) * h);
    const T difference = glm::exp(end) * dawson(middle + h) - glm::exp(begin) * dawson(middle - h);
    return way_length * glm::max(difference, T(0)) / (T(2) * h);
}

/// Extinction at the wall, as seen by light: what scatters and what absorbs.
///
/// Units:    result [1/L].
/// Shape:    the result is a spectrum.
/// Domain:   coefficients >= 0.
/// Accuracy: 2 ulp.
/// Errors:   none.
/// Source:   definition.
template <typename T, typename Scene = DefaultScene>
vec3<T> habitat_extinction(const HabitatAir<T>& air) {
    vec3<T> extinction = air.rayleigh_scattering;
    if constexpr (Scene::mie) {
        extinction += air.mie_scattering + air.mie_absorption;
    }
    return extinction;
}

/// Share of light that passes between two points.
///
/// Units:    from and to [L]; result [1], in [0, 1].
/// Shape:    the result is a spectrum.
/// Domain:   that of habitat_column.
/// Accuracy: relative as habitat_column times the optical depth, plus exp's own.
/// Errors:   none; the same in both directions.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
vec3<T> habitat_transmittance(const HabitatAir<T>& air, const vec3<T>& from, const vec3<T>& to) {
    return glm::exp(-habitat_extinction<T, Scene>(air) * habitat_column(air, from, to));
}

/// Where a ray crosses a cylinder about the x axis with flat caps.
///
/// Units:    radius and half_length [L]; origin [L] from the middle of the axis; direction a unit vector;
///           distances [L].
/// Domain:   radius and half_length >= 0.
/// Accuracy: the exact answer for inputs moved by at most 8 roundoffs of the origin's distance.
/// Errors:   a ray along the wall or in the plane of a cap counts as a hit.
/// Source:   roots without cancellation, as in intersect_ray_sphere.
template <typename T>
CylinderHit<T> intersect_capped_cylinder(T radius, T half_length, const vec3<T>& origin,
                                         const vec3<T>& direction) {
    const CylinderHit<T> missed = CylinderHit<T>{false, T(0), T(0)};
    const T sine2 = direction.y * direction.y + direction.z * direction.z;
    const T sine = glm::sqrt(sine2);
    // The closest approach to the axis times the sine, and what is left to the wall there.
    const T miss = glm::abs(origin.y * direction.z - origin.z * direction.y);
    const T gap = radius * sine - miss;
    if (gap < T(0)) {
        return missed;
    }
    const T from_axis = glm::sqrt(origin.y * origin.y + origin.z * origin.z);
    const T product = (from_axis - radius) * (from_axis + radius);
    T t_near = -no_surface<T>();
    T t_far = no_surface<T>();
    if (sine2 > T(0)) {
        const T along = origin.y * direction.y + origin.z * direction.z;
        const T half_chord = glm::sqrt(gap * (radius * sine + miss));
        // One root adds two numbers of the same sign; the roots' product gives the other.
        const T sum = along > T(0) ? -along - half_chord : -along + half_chord;
        const T root = sum / sine2;
        const T other = sum != T(0) ? product / sum : T(0);
        t_near = glm::min(root, other);
        t_far = glm::max(root, other);
    } else if (product > T(0)) {
        return missed;
    }
    if (direction.x != T(0)) {
        const T first = (-half_length - origin.x) / direction.x;
        const T second = (half_length - origin.x) / direction.x;
        t_near = glm::max(t_near, glm::min(first, second));
        t_far = glm::min(t_far, glm::max(first, second));
    } else if (glm::abs(origin.x) > half_length) {
        return missed;
    }
    if (t_near > t_far) {
        return missed;
    }
    return CylinderHit<T>{true, t_near, t_far};
}

}  // namespace airlight
