#pragma once

// What columns, optical depths and transmittances promise along one ray.

#include "extremes.hpp"
#include "promises.hpp"
#include "scenes.hpp"

namespace airlight_test {

/// How far Chapman's function may be from the truth at x = radius / scale height, as its docstring says.
template <typename T>
T chapman_error(T x) {
    return std::fmin(T(0.4L) / (x * x * x), T(0.07L)) + T(1.2e-7L);
}

/// The lowest point of a path.
template <typename T>
T lowest_altitude(const airlight::AirPath<T>& path) {
    const bool through = path.along < T(0) && path.along + path.extent > T(0);
    return through ? path.perigee_altitude : std::fmin(path.begin_altitude, path.end_altitude);
}

/// What one roundoff `u` of the altitudes on a path makes of a layer in which the density falls by e, or to
/// 0, over `thickness`: 4 roundoffs of the lengths that the altitudes are formed from; over a path longer
/// than the radius, of their squares over the radius.
template <typename T>
T altitude_roundoff(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path, T thickness, T u) {
    const T lengths = air.ground_radius + std::fabs(path.along) + path.extent;
    return T(4) * u * (T(1) + lengths * std::fmax(lengths / air.ground_radius, T(1)) / thickness);
}

/// The way that a path makes on one roundoff `u` of its altitude where it touches the top of the air.
template <typename T>
T touching_way(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path, T u) {
    const T height = std::fmax(air.top_altitude, std::fabs(lowest_altitude(path)));
    return std::sqrt(T(16) * u * height * (air.ground_radius + height));
}

/// Whether a layer of this scale height has laws on a path: not deep in the planet, where nothing passes and
/// the density stops growing, nor where one roundoff of the altitudes is worth a scale height.
template <typename T>
bool has_column_laws(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path, T scale_height,
                     T u) {
    const T low = lowest_altitude(path);
    return scale_height > T(0) && low > -T(30) * scale_height && low > T(-0.9L) * air.ground_radius &&
           altitude_roundoff(air, path, scale_height, u) < T(0.5L);
}

/// The air of an exponential layer on a level path from altitude `low` to space, a little more than
/// Chapman's.
template <typename T>
T level_air(const airlight::Atmosphere<T>& air, T low, T scale_height) {
    const T x = std::fmax(air.ground_radius + low, T(0)) / scale_height;
    return scale_height * std::exp(std::fmin(-low / scale_height, T(40))) *
           (T(1) + std::sqrt(T(0.5L) * airlight::pi<T> * x));
}

/// How far an exponential column may be off, as its docstring says: four times the error of Chapman's
/// function and the roundoff of the altitudes, of the air above the lowest point; 1e-6 of the column where
/// four points of Gauss sample it.
template <typename T>
T exponential_column_bound(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path,
                           T scale_height, T column, T u) {
    const T low = lowest_altitude(path);
    const T x = std::fmax(air.ground_radius + low, T(0)) / scale_height;
    const T smallest = std::numeric_limits<T>::min();  // below it numbers lose digits
    return level_air(air, low, scale_height) *
               (T(4) * chapman_error(x) + altitude_roundoff(air, path, scale_height, u)) +
           T(1e-6L) * column + scale_height * smallest;
}

/// How far the absorbing layer's column may be off: the Lorentz curve as its docstring says, for a difference
/// of two; both by 2 % where the layer is no longer thin against the planet (measured: 0.9 %). Further the
/// roundoff of the altitudes; the way that a path makes on one at the top of the air; and lengths whose
/// squares are too small for T.
template <typename T, typename Scene>
T ozone_column_bound(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path, T column, T u) {
    T model = T(0.02L) * column;
    if (Scene::ozone == airlight::ozone_lorentzian && air.rayleigh_scale_height > T(0)) {
        model += T(4 * 1.2e-4L) * std::fmin(level_air(air, T(0), air.rayleigh_scale_height), path.extent);
    }
    const T height = std::fmax(air.top_altitude, std::fabs(lowest_altitude(path)));
    const T smallest = std::sqrt(std::numeric_limits<T>::min()) * (air.ground_radius + height);
    return model + touching_way(air, path, u) +
           path.extent * altitude_roundoff(air, path, air.ozone_half_width, u) + smallest;
}

/// A path's two parts and the same path from its other end.
template <typename T>
struct SplitPath {
    airlight::AirPath<T> first;
    airlight::AirPath<T> second;
    airlight::AirPath<T> back;
};
template <typename T>
SplitPath<T> split(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path, T share) {
    SplitPath<T> parts = {path, path, path};
    parts.first.extent = share * path.extent;
    parts.first.end_altitude =
        airlight::altitude_along_ray(air.ground_radius, path.begin_altitude, path.along, parts.first.extent);
    parts.second.extent = path.extent - parts.first.extent;
    parts.second.along = path.along + parts.first.extent;
    parts.second.begin_altitude = parts.first.end_altitude;
    parts.back.begin_altitude = path.end_altitude;
    parts.back.end_altitude = path.begin_altitude;
    parts.back.along = -(path.along + path.extent);
    // No point of a path lies below its closest approach; where it is cut, rounding may say so.
    parts.first.perigee_altitude = std::fmin(path.perigee_altitude, parts.first.end_altitude);
    parts.second.perigee_altitude = std::fmin(path.perigee_altitude, parts.second.begin_altitude);
    parts.back.perigee_altitude = std::fmin(path.perigee_altitude, path.end_altitude);
    return parts;
}

/// The laws of one substance: the longer way holds more, two parts hold what the whole holds, and the way
/// back as much.
template <typename T>
void column_laws(Verdict& verdict, const char* grows, const char* adds_up, const char* both_ways, T whole,
                 T first, T second, T back, T bound) {
    verdict.within(grows, first - whole, bound);
    verdict.within(adds_up, std::fabs(first + second - whole), bound);
    verdict.within(both_ways, std::fabs(back - whole), bound);
}

/// `share` of the path through the air, in [0, 1], is where it is split.
template <typename T, typename Scene>
Verdict column_promises(const airlight::Atmosphere<T>& air, T altitude, T mu, T distance, T share) {
    using namespace airlight;
    Verdict verdict;
    const AirPath<T> path = air_path(air, altitude, mu, distance);
    verdict.holds("path.extent is an amount, at most the distance",
                  is_amount(path.extent) && path.extent <= distance);
    verdict.holds("path.begin_altitude is an amount", is_amount(path.begin_altitude));
    verdict.holds("path.end_altitude is finite", is_finite(path.end_altitude));

    const Column<T> whole = column<T, Scene>(air, altitude, mu, distance);
    verdict.holds("column is an amount", is_amount(vec3<T>(whole.rayleigh, whole.mie, whole.ozone)));
    const Column<T> to_space = column_to_space<T, Scene>(air, altitude, mu);
    verdict.holds("column_to_space is an amount",
                  is_amount(vec3<T>(to_space.rayleigh, to_space.mie, to_space.ozone)));
    const Column<T> marched = column_marched<T, Scene>(air, altitude, mu, distance, 3);
    verdict.holds("column_marched is an amount",
                  is_amount(vec3<T>(marched.rayleigh, marched.mie, marched.ozone)));
    verdict.holds("optical_depth is an amount",
                  is_amount(optical_depth<T, Scene>(air, altitude, mu, distance)));
    verdict.holds("transmittance is a share", is_share(transmittance<T, Scene>(air, altitude, mu, distance)));
    verdict.holds("transmittance_to_space is a share",
                  is_share(transmittance_to_space<T, Scene>(air, altitude, mu)));
    if (!(path.extent > T(0))) {
        return verdict;
    }

    const T u = std::numeric_limits<T>::epsilon() / 2;
    const SplitPath<T> parts = split(air, path, share);
    const T low = lowest_altitude(path);
    for (const T scale_height : {air.rayleigh_scale_height, air.mie_scale_height}) {
        if (has_column_laws(air, path, scale_height, u)) {
            const T all = exponential_column(air.ground_radius, path, scale_height);
            column_laws(verdict, "exponential_column grows with distance", "exponential_columns add up",
                        "exponential_column is the same from either end", all,
                        exponential_column(air.ground_radius, parts.first, scale_height),
                        exponential_column(air.ground_radius, parts.second, scale_height),
                        exponential_column(air.ground_radius, parts.back, scale_height),
                        exponential_column_bound(air, path, scale_height, all, u));
        }
    }
    // A Lorentz curve is cut 8 half widths below its centre, and bends sharply at the ground.
    const bool has_laws = Scene::ozone == ozone_lorentzian
                              ? air.ozone_altitude <= T(8) * air.ozone_half_width && low >= T(0)
                              : low > T(-0.9L) * air.ground_radius;
    if (air.ozone_half_width > T(0) && has_laws) {
        const T all = ozone_column<T, Scene>(air, path);
        column_laws(verdict, "ozone_column grows with distance", "ozone_columns add up",
                    "ozone_column is the same from either end", all, ozone_column<T, Scene>(air, parts.first),
                    ozone_column<T, Scene>(air, parts.second), ozone_column<T, Scene>(air, parts.back),
                    ozone_column_bound<T, Scene>(air, path, all, u));
    }
    return verdict;
}

template <typename T>
std::string told_ray(const airlight::Atmosphere<T>& air, T altitude, T mu, T distance, T share) {
    return told(air) + told("altitude", altitude) + told("mu", mu) + told("distance", distance) +
           told("share", share);
}

/// One ray in the scenes that differ in its columns.
template <typename T>
void check_ray(Verdict& all, const airlight::Atmosphere<T>& air, T altitude, T mu, T distance, T share) {
    const auto tell = [&] { return told_ray(air, altitude, mu, distance, share); };
    all.add(column_promises<T, airlight::DefaultScene>(air, altitude, mu, distance, share), tell);
    all.add(column_promises<T, Lorentzian>(air, altitude, mu, distance, share), tell);
    all.add(column_promises<T, Bare>(air, altitude, mu, distance, share), tell);
}

/// Any ray through any air.
template <typename T, typename Draw>
void check_any_ray(Verdict& all, Draw& draw) {
    const airlight::Atmosphere<T> air = any_atmosphere<T>(draw);
    const T altitude = any_altitude(draw, air);
    const T mu = cosine<T>(draw);
    const T distance = any_distance<T>(draw);
    check_ray(all, air, altitude, mu, distance, T(zero_or_between(draw, 1e-9, 1.0)));
}

}  // namespace airlight_test
