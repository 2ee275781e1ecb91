#pragma once

#include <airlight/atmosphere.hpp>
#include <airlight/chapman.hpp>
#include <airlight/constants.hpp>
#include <airlight/density.hpp>
#include <airlight/gauss.hpp>
#include <airlight/ray_sphere.hpp>
#include <airlight/scene.hpp>
#include <airlight/view_path.hpp>

namespace airlight {

/// The amount of each substance along a ray: relative density integrated over length.
template <typename T>
struct Column {
    T rayleigh;  ///< [L] of molecules
    T mie;       ///< [L] of aerosol, 0 where the scene has none
    T ozone;     ///< [L] of the absorbing layer, 0 where the scene has none
};

/// One amount of air plus a multiple of another.
///
/// Units:    columns [L]; factor [1]; result [L].
/// Domain:   every finite value.
/// Accuracy: 2 roundoffs of the two terms.
/// Errors:   none.
/// Source:   none.
template <typename T>
inline Column<T> column_sum(const Column<T>& a, T factor, const Column<T>& b) {
    return Column<T>{a.rayleigh + factor * b.rayleigh, a.mie + factor * b.mie, a.ozone + factor * b.ozone};
}

/// The relative density [1] of each substance at one altitude.
template <typename T>
struct Density {
    T rayleigh;  ///< [1] of molecules
    T mie;       ///< [1] of aerosol, 0 where the scene has none
    T ozone;     ///< [1] of the absorbing layer, 0 where the scene has none
};

/// Relative densities at an altitude, for the terms that the scene has.
///
/// The Lorentzian layer is the Lorentz curve times the Rayleigh density: with Leenman's numbers it
/// peaks at 28.9 km, not 30, and at 0.025.
///
/// Units:    altitude [L]; result [1].
/// Domain:   every altitude; below the ground it counts as 0. The top of the air is the caller's.
/// Accuracy: that of the density functions.
/// Errors:   none; a layer of zero thickness gives 0.
/// Source:   exponential_density, tent_density, lorentzian_density.
template <typename T, typename Scene = DefaultScene>
Density<T> relative_density(const Atmosphere<T>& atmosphere, T altitude) {
    const T rayleigh = exponential_density(altitude, atmosphere.rayleigh_scale_height);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = exponential_density(altitude, atmosphere.mie_scale_height);
    }
    T ozone = T(0);
    if constexpr (Scene::ozone == ozone_tent) {
        ozone = tent_density(altitude, atmosphere.ozone_altitude, atmosphere.ozone_half_width);
    }
    if constexpr (Scene::ozone == ozone_lorentzian) {
        ozone =
            rayleigh * lorentzian_density(altitude, atmosphere.ozone_altitude, atmosphere.ozone_half_width);
    }
    return Density<T>{rayleigh, mie, ozone};
}

/// The stretch of a ray inside the air, by its ends and by its line's closest approach to the centre.
template <typename T>
struct AirPath {
    T extent;            ///< [L] its length, 0 where the ray meets no air
    T along;             ///< [L] of its begin, from the closest approach
    T begin_altitude;    ///< [L]
    T end_altitude;      ///< [L]
    T perigee_radius;    ///< [L] of the closest approach, wherever on the line it is
    T perigee_altitude;  ///< [L] the same, above the ground sphere
};

/// The stretch of a ray inside the air, for a ray given by altitude and cosine.
///
/// Units:    altitude and distance [L]; mu [1], cosine to the vertical.
/// Domain:   altitude from the centre to a few planet radii, below the ground it counts as 0; mu in
///           [-1, 1], rounding past the ends is forgiven; distance >= 0.
/// Accuracy: that of intersect_ray_sphere and altitude_along_ray.
/// Errors:   none; ignores the ground.
/// Source:   docs/theory/altitude.md.
template <typename T>
AirPath<T> air_path(const Atmosphere<T>& atmosphere, T altitude, T mu, T distance) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    const T from_altitude = glm::max(altitude, T(0));
    const T cosine = glm::clamp(mu, T(-1), T(1));
    const T sine = safe_sqrt((T(1) - cosine) * (T(1) + cosine));
    const RaySphereHit<T> air = intersect_ray_sphere(radius + top, from_altitude - top, cosine);
    const T begin = glm::max(air.t_near, T(0));
    const T extent = glm::max(glm::min(air.t_far, distance) - begin, T(0));

    // From the entry into the air if the ray starts above it: distances from there are short.
    const T begin_altitude = begin > T(0) ? top : from_altitude;
    const T along = (radius + from_altitude) * cosine + begin;
    const T end_altitude = altitude_along_ray(radius, begin_altitude, along, extent);
    const T perigee_depth = radius * (cosine * cosine / (T(1) + sine)) - from_altitude * sine;
    return AirPath<T>{extent,        along, begin_altitude, end_altitude, (radius + from_altitude) * sine,
                      -perigee_depth};
}

/// The air of an exponential layer on a path, in closed form.
///
///     H rho_low |Ch_low - exp(-rise / H) Ch_high|, through the closest approach twice its Ch minus both
///     ends'
///
/// A path on which the density hardly changes is sampled at the four points of Gauss instead: there
/// the difference would cancel.
///
/// Units:    ground_radius and scale_height [L]; result [L].
/// Domain:   ground_radius > 0; scale_height >= 0; a path of air_path.
/// Accuracy: relative 1.7e-5 at radius / scale_height = 50, 2e-6 at 100, 3e-7 from 800 on (measured:
///           3.5e-6, 4.7e-7, 1.2e-7; the difference of two ends can hold up to four times that); plus
///           20 roundoffs and the roundoff of the lowest altitude over the scale height.
/// Errors:   none; a scale height of 0 gives 0. Below the ground the density goes on growing, to e^40.
/// Source:   docs/theory/chapman.md.
template <typename T>
T exponential_column(T ground_radius, const AirPath<T>& path, T scale_height) {
    if (scale_height <= T(0) || path.extent <= T(0)) {
        return T(0);
    }
    const T end_along = path.along + path.extent;
    const T begin_radius = ground_radius + path.begin_altitude;
    const T end_radius =
        glm::max(ground_radius + path.end_altitude, T(0.001L) * ground_radius);  // not the centre
    const bool through = path.along < T(0) && end_along > T(0);

    // How far the ends lie above the lowest point, from differences of squares.
    const T climb = path.extent * (path.along + end_along) / (begin_radius + end_radius);
    const T begin_over_perigee = path.along * path.along / (begin_radius + path.perigee_radius);
    const T end_over_perigee = end_along * end_along / (end_radius + path.perigee_radius);
    const T begin_rise = through ? begin_over_perigee : glm::max(-climb, T(0));
    const T end_rise = through ? end_over_perigee : glm::max(climb, T(0));
    const T low_altitude = through ? path.perigee_altitude : glm::min(path.begin_altitude, path.end_altitude);
    const T low_density = glm::exp(glm::min(-low_altitude / scale_height, T(40)));

    if (glm::max(begin_rise, end_rise) < T(0.25) * scale_height) {
        T sum = T(0);
        for (int i = 0; i < 4; ++i) {
            const T rise =
                altitude_along_ray(begin_radius, T(0), path.along, gauss_4_positions<T>[i] * path.extent);
            sum += gauss_4_weights<T>[i] * glm::exp(-(begin_rise + rise) / scale_height);
        }
        return path.extent * low_density * sum;
    }
    const T begin_air =
        glm::exp(-begin_rise / scale_height) * chapman(begin_radius / scale_height,
                                                       glm::min(glm::abs(path.along) / begin_radius, T(1)),
                                                       glm::min(path.perigee_radius / begin_radius, T(1)));
    const T end_air = glm::exp(-end_rise / scale_height) *
                      chapman(end_radius / scale_height, glm::min(glm::abs(end_along) / end_radius, T(1)),
                              glm::min(path.perigee_radius / end_radius, T(1)));
    if (through) {
        const T at_perigee = chapman(path.perigee_radius / scale_height, T(0), T(1));
        return scale_height * low_density * glm::max(T(2) * at_perigee - begin_air - end_air, T(0));
    }
    return scale_height * low_density * glm::abs(begin_air - end_air);
}

/// Distance along a path to a shell of given altitude, on its leg down to the closest approach or on
/// its leg up from there.
///
/// Differences of squares again: a short way between two high altitudes keeps its digits.
///
/// Units:    ground_radius and shell_altitude [L]; result [L].
/// Domain:   ground_radius > 0; any shell_altitude, below the centre it counts as the centre's; a path
///           of air_path.
/// Accuracy: 4 roundoffs plus that of the difference of the altitudes.
/// Errors:   none; a shell behind the begin gives a negative distance or 0, one below the closest
///           approach a distance past it on the way down and none past it on the way up.
/// Source:   docs/theory/altitude.md.
template <typename T>
T distance_to_shell(T ground_radius, const AirPath<T>& path, T shell_altitude, bool climbing) {
    const T shell = glm::max(shell_altitude, -ground_radius);
    const T over_perigee = shell - path.perigee_altitude;
    const T s = safe_sqrt(over_perigee * (T(2) * ground_radius + shell + path.perigee_altitude));
    const T over_begin = shell - path.begin_altitude;
    const T difference = over_begin * (T(2) * ground_radius + shell + path.begin_altitude);
    if (climbing) {
        return path.along > T(0) ? difference / (s + path.along) : s - path.along;
    }
    return path.along < T(0) ? -difference / (s - path.along) : T(0);
}

/// The absorbing layer between two shells of altitude on a path, by the four points of Gauss.
///
/// Takes both legs of the path, down to the closest approach and up from it.
///
/// Units:    low and high altitude [L]; result [L].
/// Domain:   low <= high, above the air they count as its top; a path of air_path.
/// Accuracy: to rounding where the density between the shells is a straight line.
/// Errors:   none; without an absorbing layer 0.
/// Source:   Gauss-Legendre quadrature over the distance from the closest approach.
template <typename T, typename Scene = DefaultScene>
T layer_column(const Atmosphere<T>& atmosphere, const AirPath<T>& path, T low, T high) {
    const T turn = glm::clamp(-path.along, T(0), path.extent);
    const T inner = glm::min(low, atmosphere.top_altitude);  // nothing to look for above the air
    const T outer = glm::min(high, atmosphere.top_altitude);
    T sum = T(0);
    for (int leg = 0; leg < 2; ++leg) {
        const bool climbing = leg == 1;
        const T first = distance_to_shell(atmosphere.ground_radius, path, climbing ? inner : outer, climbing);
        const T last = distance_to_shell(atmosphere.ground_radius, path, climbing ? outer : inner, climbing);
        const T from = glm::clamp(first, climbing ? turn : T(0), climbing ? path.extent : turn);
        const T to = glm::max(glm::clamp(last, climbing ? turn : T(0), climbing ? path.extent : turn), from);
        for (int i = 0; i < 4; ++i) {
            const T t = from + gauss_4_positions<T>[i] * (to - from);
            const T altitude =
                altitude_along_ray(atmosphere.ground_radius, path.begin_altitude, path.along, t);
            const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
            sum += gauss_4_weights<T>[i] * (to - from) * density.ozone;
        }
    }
    return sum;
}

/// Shells at which the Lorentz curve is cut for layer_column, in half widths from its centre [1].
template <typename T>
inline constexpr T lorentzian_shells[8] = {T(-8), T(-3), T(-1), T(0), T(1), T(3), T(8), T(25)};

/// The absorbing layer's amount on a path.
///
/// A tent is a straight line between three shells. The Lorentz curve is cut at shells 1, 3, 8 and 25
/// half widths from its centre, where four points of Gauss follow it; a curve wider than three scale
/// heights, which hardly bends before the air ends, every three scale heights from the ground.
///
/// Units:    result [L].
/// Domain:   a path of air_path; for the Lorentz curve a centre within 8 half widths of the ground.
/// Accuracy: the tent to 2e-13, where its width is small against the radius; the Lorentz curve times the
///           Rayleigh density to 1.2e-4 of the molecules that the path would hold if its lowest point lay
///           at the ground, with Leenman's numbers to 1e-4 of itself; plus the roundoff of the altitudes
///           times the path's length over the half width.
/// Errors:   none; without an absorbing layer 0.
/// Source:   layer_column.
template <typename T, typename Scene = DefaultScene>
T ozone_column(const Atmosphere<T>& atmosphere, const AirPath<T>& path) {
    const T centre = atmosphere.ozone_altitude;
    const T width = atmosphere.ozone_half_width;
    T sum = T(0);
    if constexpr (Scene::ozone == ozone_tent) {
        sum = layer_column<T, Scene>(atmosphere, path, centre - width, centre) +
              layer_column<T, Scene>(atmosphere, path, centre, centre + width);
    }
    if constexpr (Scene::ozone == ozone_lorentzian) {
        const T scale_height = atmosphere.rayleigh_scale_height;
        const bool wide = width > T(3) * scale_height;
        for (int i = 0; i < 7; ++i) {
            const T low = wide ? T(3 * i) * scale_height : centre + lorentzian_shells<T>[i] * width;
            const T high = wide ? T(3 * i + 3) * scale_height : centre + lorentzian_shells<T>[i + 1] * width;
            sum += layer_column<T, Scene>(atmosphere, path, low, high);
        }
    }
    return sum;
}

/// The air along a ray, in closed form.
///
/// Ignores the ground: below it the exponential densities go on growing, and nothing passes.
///
/// Units:    altitude and distance [L]; mu [1], cosine to the vertical; result [L].
/// Domain:   altitude from the centre to a few planet radii (further out mu has no digits left);
///           below the ground it counts as 0; mu in [-1, 1]; distance >= 0.
/// Accuracy: that of exponential_column and ozone_column.
/// Errors:   none; no air on the ray gives 0.
/// Source:   docs/theory/chapman.md.
template <typename T, typename Scene = DefaultScene>
Column<T> column(const Atmosphere<T>& atmosphere, T altitude, T mu, T distance) {
    const AirPath<T> path = air_path(atmosphere, altitude, mu, distance);
    const T rayleigh = exponential_column(atmosphere.ground_radius, path, atmosphere.rayleigh_scale_height);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = exponential_column(atmosphere.ground_radius, path, atmosphere.mie_scale_height);
    }
    return Column<T>{rayleigh, mie, ozone_column<T, Scene>(atmosphere, path)};
}

/// The air along a ray to the end of the air, in closed form.
///
/// Units:    altitude [L]; mu [1], cosine to the vertical; result [L].
/// Domain:   that of column.
/// Accuracy: that of column.
/// Errors:   none; ignores the ground as column does.
/// Source:   column.
template <typename T, typename Scene = DefaultScene>
Column<T> column_to_space(const Atmosphere<T>& atmosphere, T altitude, T mu) {
    return column<T, Scene>(atmosphere, altitude, mu, no_surface<T>());
}

/// The air along a ray, summed over `steps` equal steps by the midpoint rule.
///
/// Ignores the ground: below it the densities keep their ground value.
///
/// Units:    altitude and distance [L]; mu [1], cosine to the vertical; result [L].
/// Domain:   altitude from the centre to a few planet radii (further out mu has no digits left);
///           below the ground it counts as 0; mu in [-1, 1]; distance >= 0; steps >= 1.
/// Accuracy: second order: four times better per doubling of steps, once a step is shorter than
///           the smallest scale height it crosses. Rounding: that of altitude_along_ray.
/// Errors:   steps < 1 gives 0.
/// Source:   midpoint rule.
template <typename T, typename Scene = DefaultScene>
Column<T> column_marched(const Atmosphere<T>& atmosphere, T altitude, T mu, T distance, int steps) {
    const AirPath<T> path = air_path(atmosphere, altitude, mu, distance);
    const T step_length = path.extent / glm::max(T(steps), T(1));
    Column<T> sum = Column<T>{T(0), T(0), T(0)};
    for (int i = 0; i < steps; ++i) {
        const T here = altitude_along_ray(atmosphere.ground_radius, path.begin_altitude, path.along,
                                          (T(i) + T(0.5)) * step_length);
        const Density<T> density = relative_density<T, Scene>(atmosphere, here);
        sum.rayleigh += density.rayleigh;
        sum.mie += density.mie;
        sum.ozone += density.ozone;
    }
    return Column<T>{sum.rayleigh * step_length, sum.mie * step_length, sum.ozone * step_length};
}

}  // namespace airlight
