#pragma once

// Where tables of scattered light keep what: three dimensions (altitude, view, sun), and four of them
// packed into three (the angle between view and sun too).

#include <airlight/table_mapping.hpp>

namespace airlight {

/// A point of a table over altitude, view direction and sun.
template <typename T>
struct AltitudeViewSun {
    T altitude;           ///< [L] in [0, top_altitude]
    T mu;                 ///< [1] cosine between the view and the vertical
    T mu_s;               ///< [1] cosine between the sun and the vertical
    bool reaches_ground;  ///< whether the view ends on the ground sphere
};

/// A point of a table over altitude, view direction, sun, and the angle between these two.
template <typename T>
struct ScatteringPoint {
    T altitude;           ///< [L] in [0, top_altitude]
    T mu;                 ///< [1] cosine between the view and the vertical
    T mu_s;               ///< [1] cosine between the sun and the vertical
    T nu;                 ///< [1] cosine between the view and the sun
    bool reaches_ground;  ///< whether the view ends on the ground sphere
};

/// Where a four-dimensional table is read: two places of its three-dimensional texture and their mixture.
template <typename T>
struct ScatteringLookup {
    vec3<T> first;   ///< [1] texture coordinates at the next lower nu
    vec3<T> second;  ///< [1] at the next higher one
    T weight;        ///< [1] of the second; the first has 1 - weight
};

/// The lowest sun that lights air in the sight of any point of the air: a line of sight from the top grazes
/// the ground and comes out at the top again, where sunlight that grazes the ground too is about to leave.
/// Each of the three ways between ground and top turns the vertical by d.
///
///     -sin(3 d),  cos(d) = R / (R + top)
///
/// Seen from the ground the last light is gone earlier, at -sin(2 d).
///
/// Units:    result [1], a cosine between the sun and the vertical, in [-1, 0].
/// Domain:   ground_radius > 0, top_altitude >= 0.
/// Accuracy: 8 roundoffs.
/// Errors:   -1 where the air is so high that the sun is always in sight of some of it.
/// Source:   derived here.
template <typename T>
T lowest_sun_cosine(const Atmosphere<T>& atmosphere) {
    const T radius = atmosphere.ground_radius;
    const T outer = radius + atmosphere.top_altitude;
    const T sine = horizon_distance(radius, atmosphere.top_altitude) / outer;
    const T cosine = radius / outer;
    const T four_squares = T(4) * cosine * cosine;
    return four_squares > T(3) ? sine * (T(1) - four_squares) : T(-1);
}

/// How the sun's axis of inscatter_uvw bends: sampled (1 + 1/bend)^2 = 30 times as densely at the horizon
/// as at the zenith, as the tangent in its source is.
template <typename T>
inline constexpr T sun_axis_bend = T(0.225L);

/// Where a table over altitude (x), view (y) and sun (z) is read, all three even.
///
///     x = altitude / top_altitude,   y = (1 + mu) / 2,   z = (1 + mu_s) / 2
///
/// Units:    altitude [L]; mu and mu_s [1]; sizes in texels; result [1], in [0, 1].
/// Domain:   every altitude and cosine, see table_altitude; sizes >= 1.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   the plainest choice; the light changes at once at the horizon, where this has few texels.
template <typename T>
vec3<T> linear_inscatter_uvw(const Atmosphere<T>& atmosphere, T altitude, T mu, T mu_s, int width, int height,
                             int depth) {
    const T x = share_of(table_altitude(atmosphere, altitude), atmosphere.top_altitude);
    return vec3<T>(texture_from_unit(x, width), texture_from_unit(T(0.5) * (T(1) + table_cosine(mu)), height),
                   texture_from_unit(T(0.5) * (T(1) + table_cosine(mu_s)), depth));
}

/// The inverse of linear_inscatter_uvw.
///
/// Units:    uvw [1]; sizes in texels.
/// Domain:   every uvw; sizes >= 1.
/// Accuracy: 4 roundoffs of the size.
/// Errors:   a view exactly on the horizon does not reach the ground.
/// Source:   as linear_inscatter_uvw.
template <typename T>
AltitudeViewSun<T> linear_inscatter_parameters(const Atmosphere<T>& atmosphere, const vec3<T>& uvw, int width,
                                               int height, int depth) {
    const T altitude = unit_from_texture(uvw.x, width) * atmosphere.top_altitude;
    const T mu = T(2) * unit_from_texture(uvw.y, height) - T(1);
    return AltitudeViewSun<T>{altitude, mu, T(2) * unit_from_texture(uvw.z, depth) - T(1),
                              mu < horizon_cosine(atmosphere.ground_radius, altitude)};
}

/// Where a table over altitude (x), view (y) and sun (z) is read, with texels crowding where the light
/// changes: at the ground, at the view's horizon, at sunset.
///
///     x = sqrt(altitude / top_altitude)
///     y = 1/2 + ((mu - mu_h) / (1 - mu_h))^(1/5) / 2      above the horizon
///     y = 1/2 - ((mu_h - mu) / (1 + mu_h))^(1/5) / 2      on the ground
///     z = (s(mu_s) - s(lowest_sun)) / (1 - s(lowest_sun)),   s = bent_sun
///
/// The sources have an arc tangent for z, which shaders compute as they like; s has its shape.
///
/// Units:    altitude [L]; mu, mu_s and lowest_sun [1]; sizes in texels; result [1], in [0, 1].
/// Domain:   every altitude and cosine, see table_altitude; lowest_sun in [-1, 1), see lowest_sun_cosine;
///           sizes >= 1, height even.
/// Accuracy: 8 roundoffs, and the fifth root of those that mu and the horizon's cosine have: beside the
///           horizon a float tells 32 rows apart on every world, 64 on Earth.
/// Errors:   a sun below lowest_sun counts as there.
/// Source:   Yusov, Diligent epipolar light scattering, shaders (2019), powers 1/2 and 1/5, the two halves;
///           planetary scattering in ralith's shaders, mapping.h, the horizon in the middle.
template <typename T>
vec3<T> inscatter_uvw(const Atmosphere<T>& atmosphere, T altitude, T mu, T mu_s, bool reaches_ground,
                      T lowest_sun, int width, int height, int depth) {
    const T radius = atmosphere.ground_radius;
    const T above = table_altitude(atmosphere, altitude);
    const T x = glm::sqrt(share_of(above, atmosphere.top_altitude));

    const T horizon = horizon_cosine(radius, above);
    const T below_horizon = cosines_below_horizon(radius, above, horizon);
    const T from_horizon =
        reaches_ground ? share_of(horizon - mu, below_horizon) : share_of(mu - horizon, T(1) - horizon);
    const T y = from_horizon > T(0) ? glm::pow(from_horizon, T(0.2L)) : T(0);

    const T bend = sun_axis_bend<T>;
    const T lowest = bent_sun(lowest_sun, bend);
    const T z = share_of(bent_sun(table_cosine(mu_s), bend) - lowest, T(1) - lowest);
    return vec3<T>(texture_from_unit(x, width), texture_from_halves(y, !reaches_ground, height),
                   texture_from_unit(z, depth));
}

/// The inverse of inscatter_uvw.
///
/// Units:    uvw and lowest_sun [1]; sizes in texels.
/// Domain:   every uvw; lowest_sun in [-1, 1); sizes >= 1, height even.
/// Accuracy: 16 roundoffs of the size.
/// Errors:   none.
/// Source:   as inscatter_uvw.
template <typename T>
AltitudeViewSun<T> inscatter_parameters(const Atmosphere<T>& atmosphere, const vec3<T>& uvw, T lowest_sun,
                                        int width, int height, int depth) {
    const T radius = atmosphere.ground_radius;
    const T x = unit_from_texture(uvw.x, width);
    const T altitude = x * x * atmosphere.top_altitude;

    const bool reaches_ground = uvw.y <= T(0.5);
    const T horizon = horizon_cosine(radius, altitude);
    const T below_horizon = cosines_below_horizon(radius, altitude, horizon);
    const T y = unit_from_halves(uvw.y, height);
    const T from_horizon = y * y * (y * y) * y;
    const T mu =
        reaches_ground ? horizon - from_horizon * below_horizon : horizon + from_horizon * (T(1) - horizon);

    const T bend = sun_axis_bend<T>;
    const T lowest = bent_sun(lowest_sun, bend);
    const T mu_s = sun_from_bent(lowest + unit_from_texture(uvw.z, depth) * (T(1) - lowest), bend);
    return AltitudeViewSun<T>{altitude, table_cosine(mu), mu_s, reaches_ground};
}

/// How much longer a ray to the ground is than the vertical one.
///
///     d - h = d (R + h) (1 + mu) / (2 R + h) (1 + (R + h) (1 - mu) / (R + s))
///
/// with s the ray's half chord in the ground sphere.
///
/// Units:    lengths [L]; mu [1]; result [L].
/// Domain:   ground_radius > 0; altitude >= 0; mu in [-1, 0], at or below the horizon.
/// Accuracy: 12 roundoffs, where s is above a thousandth of the radius.
/// Errors:   none; above the horizon it counts as on it.
/// Source:   roots without cancellation as in intersect_ray_sphere.
template <typename T>
T excess_to_ground(T ground_radius, T altitude, T mu) {
    const T radius = ground_radius + altitude;
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    const T depth = ground_radius * (mu * mu / (T(1) + sine)) - altitude * sine;
    const T half_chord = safe_sqrt(depth * (ground_radius + radius * sine));
    const T product = altitude * (T(2) * ground_radius + altitude);
    const T distance = product > T(0) ? product / (half_chord - radius * mu) : T(0);
    const T bend = T(1) + radius * (T(1) - mu) / (ground_radius + half_chord);
    return distance * (radius * (T(1) + mu) / (T(2) * ground_radius + altitude)) * bend;
}

/// The excess_to_ground of the ray to the horizon, the distance to it less the altitude.
///
/// Units:    lengths [L]; result [L].
/// Domain:   ground_radius > 0; altitude >= 0.
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   excess_to_ground with no half chord.
template <typename T>
T excess_to_horizon(T ground_radius, T altitude) {
    const T horizon = horizon_distance(ground_radius, altitude);
    const T twice = T(2) * ground_radius + altitude;
    return horizon * (ground_radius / twice) * ((twice + horizon) / (ground_radius + altitude + horizon));
}

/// The share, in [0, 1], that spreads suns in a table: from lowest_sun (0) to the zenith (1), with more room
/// at the horizon.
///
///     x = (1 - a / A) / (1 + a)
///
/// with a the excess_to_top of the sunlight on the ground over that at the horizon, A its largest.
///
/// Units:    mu_s and lowest_sun [1]; result [1].
/// Domain:   mu_s in [-1, 1]; lowest_sun in [-1, 1).
/// Accuracy: 64 roundoffs.
/// Errors:   a sun below lowest_sun counts as there.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl; A here exactly.
template <typename T>
T unit_from_sun(const Atmosphere<T>& atmosphere, T mu_s, T lowest_sun) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    const T at_horizon = excess_to_top(radius, top, T(0), T(0));
    const T most = excess_to_top(radius, top, T(0), lowest_sun);
    const T excess = excess_to_top(radius, top, T(0), mu_s);
    return at_horizon > T(0) ? share_of(most - excess, most) * share_of(at_horizon, at_horizon + excess)
                             : T(0);
}

/// The inverse of unit_from_sun.
///
/// Units:    x and lowest_sun [1]; result [1], from lowest_sun to 1.
/// Domain:   x in [0, 1]; lowest_sun in [-1, 1).
/// Accuracy: 64 roundoffs of 1.
/// Errors:   none.
/// Source:   as unit_from_sun.
template <typename T>
T sun_from_unit(const Atmosphere<T>& atmosphere, T x, T lowest_sun) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    const T at_horizon = excess_to_top(radius, top, T(0), T(0));
    const T most = excess_to_top(radius, top, T(0), lowest_sun);
    const T excess = most * share_of(at_horizon * (T(1) - x), at_horizon + x * most);
    return glm::max(cosine_from_excess(radius, top, T(0), excess), lowest_sun);
}

/// A cosine between view and sun that these two can have: a table has places for others too.
///
///     |nu - mu mu_s| <= sqrt((1 - mu^2) (1 - mu_s^2))
///
/// Units:    mu, mu_s and nu [1]; result [1].
/// Domain:   all in [-1, 1].
/// Accuracy: 4 roundoffs of 1.
/// Errors:   none.
/// Source:   spherical law of cosines.
template <typename T>
T possible_nu(T mu, T mu_s, T nu) {
    const T middle = mu * mu_s;
    const T reach = safe_sqrt((T(1) - mu) * (T(1) + mu)) * safe_sqrt((T(1) - mu_s) * (T(1) + mu_s));
    return table_cosine(glm::clamp(nu, middle - reach, middle + reach));
}

/// Where a four-dimensional table is read. The texture's x has the sun for each nu side by side, y the view
/// (rays to the ground in its lower half, each half even in the ray's length), z the altitude: it is
/// nu_size * mu_s_size texels wide, mu_size high, altitude_size deep.
///
/// Units:    altitude [L]; mu, mu_s, nu and lowest_sun [1]; result [1].
/// Domain:   every altitude and cosine, see table_altitude; lowest_sun in [-1, 1), see lowest_sun_cosine;
///           sizes >= 1, mu_size even.
/// Accuracy: 64 roundoffs of the size; on the ground's horizon the root of one, a fiftieth of a texel in
///           float for 128 texels.
/// Errors:   a sun below lowest_sun counts as there.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl; in altitudes.
template <typename T>
ScatteringLookup<T> scattering_lookup(const Atmosphere<T>& atmosphere, T altitude, T mu, T mu_s, T nu,
                                      bool reaches_ground, T lowest_sun, int nu_size, int mu_s_size,
                                      int mu_size, int altitude_size) {
    const T above = table_altitude(atmosphere, altitude);
    const T view = table_cosine(mu);
    const T ground = share_of(excess_to_ground(atmosphere.ground_radius, above, glm::min(view, T(0))),
                              excess_to_horizon(atmosphere.ground_radius, above));
    const T x_mu = reaches_ground ? ground : unit_from_upward_cosine(atmosphere, above, view);
    const T v = texture_from_halves(x_mu, !reaches_ground, mu_size);
    const T w = texture_from_unit(unit_from_altitude(atmosphere, above), altitude_size);
    const T u = texture_from_unit(unit_from_sun(atmosphere, table_cosine(mu_s), lowest_sun), mu_s_size);

    const T last = T(nu_size - 1);
    const T at_nu = share_of(T(1) + nu, T(2)) * last;
    const T first = glm::floor(at_nu);
    const T second = glm::min(first + T(1), last);
    return ScatteringLookup<T>{vec3<T>((first + u) / T(nu_size), v, w),
                               vec3<T>((second + u) / T(nu_size), v, w), at_nu - first};
}

/// What a texel of a four-dimensional table stands for: the inverse of scattering_lookup on the planes of
/// nu. Its nu may be one that the view and the sun cannot have, see possible_nu.
///
/// Units:    uvw and lowest_sun [1].
/// Domain:   uvw in [0, 1]; lowest_sun in [-1, 1); sizes >= 1, mu_size even.
/// Accuracy: 64 roundoffs of the size.
/// Errors:   none.
/// Source:   as scattering_lookup.
template <typename T>
ScatteringPoint<T> scattering_parameters(const Atmosphere<T>& atmosphere, const vec3<T>& uvw, T lowest_sun,
                                         int nu_size, int mu_s_size, int mu_size, int altitude_size) {
    const T radius = atmosphere.ground_radius;
    const T altitude = altitude_from_unit(atmosphere, unit_from_texture(uvw.z, altitude_size));

    const bool reaches_ground = uvw.y <= T(0.5);
    const T x_mu = unit_from_halves(uvw.y, mu_size);
    const T distance = altitude + x_mu * excess_to_horizon(radius, altitude);
    const T product = altitude * (T(2) * radius + altitude);
    const T down = distance > T(0) ? -(product / distance + distance) / (T(2) * (radius + altitude)) : T(-1);
    const T ground = glm::min(table_cosine(down), horizon_cosine(radius, altitude));
    const T mu = reaches_ground ? ground : upward_cosine_from_unit(atmosphere, altitude, x_mu);

    const T along = uvw.x * T(nu_size);
    const T plane = glm::clamp(glm::floor(along), T(0), T(nu_size - 1));
    const T mu_s = sun_from_unit(atmosphere, unit_from_texture(along - plane, mu_s_size), lowest_sun);
    const T nu = nu_size > 1 ? T(2) * plane / T(nu_size - 1) - T(1) : T(0);
    return ScatteringPoint<T>{altitude, mu, mu_s, nu, reaches_ground};
}

}  // namespace airlight
