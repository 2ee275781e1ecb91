#pragma once

// Where a table keeps what: parameters to texture coordinates and back. Each mapping is a pair, and the half
// texel between the edge of a texture and the centre of its first texel is inside. Here what the mappings
// share, and the two-dimensional ones; scattering_mapping.hpp and sky_view_mapping.hpp have the rest.

#include <airlight/atmosphere.hpp>
#include <airlight/numeric.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// A point of a table over altitude and one cosine.
template <typename T>
struct AltitudeCosine {
    T altitude;  ///< [L] in [0, top_altitude]
    T mu;        ///< [1] in [-1, 1], cosine between a direction and the vertical
};

/// A share in [0, 1], whatever it is given.
///
/// Units:    part and whole in one unit; result [1].
/// Domain:   every number.
/// Accuracy: 1 roundoff.
/// Errors:   a whole of 0 or less gives 0; so does NaN in C++.
/// Source:   none.
template <typename T>
T share_of(T part, T whole) {
    return whole > T(0) ? glm::min(glm::max(T(0), part / whole), T(1)) : T(0);
}

/// The coordinate at which a texture returns its first texel for x = 0 and its last one for x = 1.
///
///     u = (1/2 + x (size - 1)) / size
///
/// Units:    x [1]; size in texels; result [1], in [0, 1].
/// Domain:   size >= 1; x outside [0, 1] counts as the end it is closer to.
/// Accuracy: 2 roundoffs.
/// Errors:   NaN gives the first texel in C++.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl, texture coordinates.
template <typename T>
T texture_from_unit(T x, int size) {
    return (T(0.5) + share_of(x, T(1)) * T(size - 1)) / T(size);
}

/// The inverse of texture_from_unit.
///
///     x = (u size - 1/2) / (size - 1)
///
/// Units:    u [1]; size in texels; result [1], in [0, 1].
/// Domain:   size >= 1; u outside the centres of the first and last texel counts as that centre.
/// Accuracy: 2 roundoffs of size.
/// Errors:   a single texel gives 0; so does NaN in C++.
/// Source:   as texture_from_unit.
template <typename T>
T unit_from_texture(T u, int size) {
    return share_of(u * T(size) - T(0.5), T(size - 1));
}

/// The altitude at which a table is read: the ground for what lies below it, the top for what lies above.
/// This is the one rule for all tables.
///
/// Units:    altitude [L]; result [L].
/// Domain:   top_altitude >= 0.
/// Accuracy: exact.
/// Errors:   NaN gives 0 in C++.
/// Source:   none.
template <typename T>
T table_altitude(const Atmosphere<T>& atmosphere, T altitude) {
    return glm::min(glm::max(T(0), altitude), atmosphere.top_altitude);
}

/// A cosine that rounding may have pushed out of [-1, 1].
///
/// Units:    mu [1]; result [1].
/// Domain:   every number.
/// Accuracy: exact.
/// Errors:   NaN gives -1 in C++.
/// Source:   none.
template <typename T>
T table_cosine(T mu) {
    return glm::min(glm::max(T(-1), mu), T(1));
}

/// Texture coordinate of an axis whose lower and upper half are tables of their own, so that filtering
/// never mixes them: x = 0 is where they meet, 1 the far end.
///
/// Units:    x [1]; size in texels; result [1].
/// Domain:   size even, at least 2.
/// Accuracy: 3 roundoffs.
/// Errors:   none.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl.
template <typename T>
T texture_from_halves(T x, bool upper, int size) {
    const T within = T(0.5) * texture_from_unit(x, size / 2);
    return upper ? T(0.5) + within : T(0.5) - within;
}

/// The x of texture_from_halves; the half is the upper one where u > 1/2.
///
/// Units:    u [1]; size in texels; result [1], in [0, 1].
/// Domain:   size even, at least 2.
/// Accuracy: 3 roundoffs of size.
/// Errors:   none.
/// Source:   as texture_from_halves.
template <typename T>
T unit_from_halves(T u, int size) {
    return unit_from_texture(glm::abs(T(2) * u - T(1)), size / 2);
}

/// The sun's height, bent so that the horizon gets more room, (1 + 1 / bend)^2 times that of the zenith.
///
///     (1 + bend) mu / (|mu| + bend)
///
/// Units:    mu_s and bend [1]; result [1], in [-1, 1].
/// Domain:   mu_s in [-1, 1]; bend > 0.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   chosen: the shape of the arc tangents in the sources of inscatter_uvw, by arithmetic alone.
template <typename T>
T bent_sun(T mu_s, T bend) {
    return (T(1) + bend) * mu_s / (bend + glm::abs(mu_s));
}

/// The inverse of bent_sun.
///
/// Units:    bent and bend [1]; result [1], in [-1, 1].
/// Domain:   bent in [-1, 1]; bend > 0.
/// Accuracy: 4 roundoffs, and 1 + bend over bend times that of bent.
/// Errors:   none.
/// Source:   as bent_sun.
template <typename T>
T sun_from_bent(T bent, T bend) {
    return table_cosine(bend * bent / (bend + (T(1) - glm::abs(bent))));
}

/// Distance from a point to its horizon on the ground sphere.
///
/// Units:    ground_radius, altitude and result [L].
/// Domain:   ground_radius > 0; altitude >= 0.
/// Accuracy: 3 roundoffs.
/// Errors:   below the ground 0.
/// Source:   Pythagoras.
template <typename T>
T horizon_distance(T ground_radius, T altitude) {
    return safe_sqrt(altitude * (T(2) * ground_radius + altitude));
}

/// The altitude that has its horizon at a distance.
///
///     r - R = distance^2 / (R + sqrt(R^2 + distance^2))
///
/// Units:    ground_radius, distance and result [L].
/// Domain:   ground_radius > 0; distance >= 0.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   difference of squares.
template <typename T>
T altitude_of_horizon(T ground_radius, T distance) {
    const T square = distance * distance;
    return square / (ground_radius + glm::sqrt(ground_radius * ground_radius + square));
}

/// Cosine between the vertical and the horizon: 0 on the ground, towards -1 from far away.
///
/// Units:    ground_radius and altitude [L]; result [1].
/// Domain:   ground_radius > 0; altitude >= 0.
/// Accuracy: 5 roundoffs.
/// Errors:   below the ground 0.
/// Source:   definition.
template <typename T>
T horizon_cosine(T ground_radius, T altitude) {
    return -horizon_distance(ground_radius, altitude) / (ground_radius + altitude);
}

/// The range of cosines between the horizon and the nadir: 1 + horizon_cosine, but without cancellation.
///
///     1 + mu_h = (R / (R + h))^2 / (1 - mu_h)
///
/// Units:    ground_radius and altitude [L]; horizon, the horizon_cosine of both, and result [1].
/// Domain:   ground_radius > 0; altitude >= 0.
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   difference of squares.
template <typename T>
T cosines_below_horizon(T ground_radius, T altitude, T horizon) {
    const T share = ground_radius / (ground_radius + altitude);
    return share * share / (T(1) - horizon);
}

/// By how much a cosine has to exceed the horizon's for a ray to pass the ground in float [1]: ten roundoffs
/// of 1, a tenth of a second of arc.
template <typename T>
inline constexpr T past_the_horizon = T(6e-7L);

/// The sun at a height, in the frame in which tables are filled: the vertical is z, the sun stands over x.
///
/// Units:    mu_s [1], cosine between the sun and the vertical; result a unit vector.
/// Domain:   every number, see table_cosine.
/// Accuracy: 3 roundoffs.
/// Errors:   none.
/// Source:   Pythagoras.
template <typename T>
vec3<T> sun_over_x(T mu_s) {
    const T cosine = table_cosine(mu_s);
    return vec3<T>(safe_sqrt((T(1) - cosine) * (T(1) + cosine)), T(0), cosine);
}

/// How much longer a ray to the top of the air is than the vertical one.
///
///     d - (top - h) = d (R + h) (1 - mu) / (2 R + top + h) (1 + (R + h) (1 + mu) / (R + top + s))
///
/// with s the ray's half chord in the sphere of the top: a product of positive terms, nothing cancels.
///
/// Units:    lengths [L]; mu [1]; result [L].
/// Domain:   ground_radius > 0; altitude in [0, top_altitude]; mu in [-1, 1]. Ignores the ground.
/// Accuracy: 12 roundoffs.
/// Errors:   none.
/// Source:   roots without cancellation as in intersect_ray_sphere.
template <typename T>
T excess_to_top(T ground_radius, T top_altitude, T altitude, T mu) {
    const T radius = ground_radius + altitude;
    const T along = radius * mu;
    const T sum = T(2) * ground_radius + top_altitude + altitude;
    const T gap = (top_altitude - altitude) * sum;
    const T half_chord = safe_sqrt(along * along + gap);
    const T distance = along > T(0) ? gap / (along + half_chord) : half_chord - along;
    const T bend = T(1) + radius * (T(1) + mu) / (ground_radius + top_altitude + half_chord);
    return distance * (radius * (T(1) - mu) / sum) * bend;
}

/// The inverse of excess_to_top: the cosine of the ray that is longer than the vertical one by `excess`.
///
/// Units:    lengths [L]; result [1], in [-1, 1].
/// Domain:   ground_radius > 0; altitude in [0, top_altitude]; excess >= 0.
/// Accuracy: 6 roundoffs of 1.
/// Errors:   at the top, where rays upward have no length, an excess of 0 gives the vertical.
/// Source:   law of cosines.
template <typename T>
T cosine_from_excess(T ground_radius, T top_altitude, T altitude, T excess) {
    const T shortest = top_altitude - altitude;
    const T distance = shortest + excess;
    if (distance <= T(0)) {
        return T(1);
    }
    const T sum = T(2) * ground_radius + top_altitude + altitude;
    return table_cosine((shortest / distance * sum - distance) / (T(2) * (ground_radius + altitude)));
}

/// Where a table over altitude and angle is read: x is the altitude, y the angle, 0 up and 1 down.
///
///     x = altitude / top_altitude,   y = (1 - mu) / 2
///
/// Units:    altitude [L]; mu [1]; width and height in texels; result [1], in [0, 1].
/// Domain:   every altitude and cosine, see table_altitude; width and height >= 1.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   the plainest choice; even in the cosine, so few texels lie close to the horizon.
template <typename T>
vec2<T> extinction_uv(const Atmosphere<T>& atmosphere, T altitude, T mu, int width, int height) {
    const T x = share_of(table_altitude(atmosphere, altitude), atmosphere.top_altitude);
    const T y = T(0.5) * (T(1) - table_cosine(mu));
    return vec2<T>(texture_from_unit(x, width), texture_from_unit(y, height));
}

/// The inverse of extinction_uv.
///
/// Units:    uv [1]; width and height in texels.
/// Domain:   every uv; width and height >= 1.
/// Accuracy: 4 roundoffs of the size.
/// Errors:   none.
/// Source:   as extinction_uv.
template <typename T>
AltitudeCosine<T> extinction_parameters(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int width,
                                        int height) {
    return AltitudeCosine<T>{unit_from_texture(uv.x, width) * atmosphere.top_altitude,
                             T(1) - T(2) * unit_from_texture(uv.y, height)};
}

/// The share, in [0, 1], that spreads altitudes in a table: even in the distance to the horizon, so that
/// texels crowd at the ground.
///
/// Units:    altitude [L]; result [1].
/// Domain:   every altitude, see table_altitude.
/// Accuracy: 5 roundoffs.
/// Errors:   none.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl; in altitudes.
template <typename T>
T unit_from_altitude(const Atmosphere<T>& atmosphere, T altitude) {
    return share_of(horizon_distance(atmosphere.ground_radius, table_altitude(atmosphere, altitude)),
                    horizon_distance(atmosphere.ground_radius, atmosphere.top_altitude));
}

/// The inverse of unit_from_altitude.
///
/// Units:    x [1]; result [L].
/// Domain:   x in [0, 1].
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   as unit_from_altitude.
template <typename T>
T altitude_from_unit(const Atmosphere<T>& atmosphere, T x) {
    const T distance = x * horizon_distance(atmosphere.ground_radius, atmosphere.top_altitude);
    return glm::min(altitude_of_horizon(atmosphere.ground_radius, distance), atmosphere.top_altitude);
}

/// The share, in [0, 1], that spreads the directions above the horizon: even in the ray's length, from the
/// vertical (0) to the horizon (1).
///
/// Units:    altitude [L]; mu [1]; result [1].
/// Domain:   altitude in [0, top_altitude]; mu in [-1, 1]; below the horizon 1.
/// Accuracy: 30 roundoffs.
/// Errors:   none.
/// Source:   as unit_from_altitude.
template <typename T>
T unit_from_upward_cosine(const Atmosphere<T>& atmosphere, T altitude, T mu) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    return share_of(excess_to_top(radius, top, altitude, mu),
                    excess_to_top(radius, top, altitude, horizon_cosine(radius, altitude)));
}

/// The inverse of unit_from_upward_cosine.
///
/// Units:    altitude [L]; x [1]; result [1], from the horizon's cosine to 1.
/// Domain:   altitude in [0, top_altitude]; x in [0, 1].
/// Accuracy: 30 roundoffs of 1.
/// Errors:   none.
/// Source:   as unit_from_altitude.
template <typename T>
T upward_cosine_from_unit(const Atmosphere<T>& atmosphere, T altitude, T x) {
    const T radius = atmosphere.ground_radius;
    const T top = atmosphere.top_altitude;
    const T horizon = horizon_cosine(radius, altitude);
    const T excess = x * excess_to_top(radius, top, altitude, horizon);
    return glm::max(cosine_from_excess(radius, top, altitude, excess), horizon);
}

/// Where a table of transmittances to space is read: x is the direction, y the altitude. Only directions
/// above the horizon have a place.
///
/// Units:    altitude [L]; mu [1]; width and height in texels; result [1], in [0, 1].
/// Domain:   every altitude and cosine, see table_altitude; below the horizon the horizon's place.
/// Accuracy: 32 roundoffs.
/// Errors:   none.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl; in altitudes.
template <typename T>
vec2<T> transmittance_uv(const Atmosphere<T>& atmosphere, T altitude, T mu, int width, int height) {
    const T above = table_altitude(atmosphere, altitude);
    return vec2<T>(texture_from_unit(unit_from_upward_cosine(atmosphere, above, table_cosine(mu)), width),
                   texture_from_unit(unit_from_altitude(atmosphere, above), height));
}

/// The inverse of transmittance_uv. The last column is the horizon to rounding: what fills the table has to
/// ignore the ground.
///
/// Units:    uv [1]; width and height in texels.
/// Domain:   every uv; width and height >= 1.
/// Accuracy: 32 roundoffs of 1 in mu, 8 in altitude, times the size.
/// Errors:   none.
/// Source:   as transmittance_uv.
template <typename T>
AltitudeCosine<T> transmittance_parameters(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int width,
                                           int height) {
    const T altitude = altitude_from_unit(atmosphere, unit_from_texture(uv.y, height));
    return AltitudeCosine<T>{altitude,
                             upward_cosine_from_unit(atmosphere, altitude, unit_from_texture(uv.x, width))};
}

/// Where a table over the sun's height and the altitude is read, both even: irradiance on the ground and in
/// the air, light that has been scattered many times.
///
///     x = (1 + mu_s) / 2,   y = altitude / top_altitude
///
/// Units:    altitude [L]; mu_s [1], cosine between the sun and the vertical; result [1], in [0, 1].
/// Domain:   every altitude and cosine, see table_altitude; width and height >= 1.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   Bruneton, precomputed_atmospheric_scattering (2017), functions.glsl, irradiance; the same in
///           Hillaire, UnrealEngineSkyAtmosphere (2020), RenderSkyCommon.hlsl, multiple scattering.
template <typename T>
vec2<T> altitude_sun_uv(const Atmosphere<T>& atmosphere, T altitude, T mu_s, int width, int height) {
    const T x = T(0.5) * (T(1) + table_cosine(mu_s));
    const T y = share_of(table_altitude(atmosphere, altitude), atmosphere.top_altitude);
    return vec2<T>(texture_from_unit(x, width), texture_from_unit(y, height));
}

/// The inverse of altitude_sun_uv.
///
/// Units:    uv [1]; width and height in texels.
/// Domain:   every uv; width and height >= 1.
/// Accuracy: 4 roundoffs of the size.
/// Errors:   none.
/// Source:   as altitude_sun_uv.
template <typename T>
AltitudeCosine<T> altitude_sun_parameters(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int width,
                                          int height) {
    return AltitudeCosine<T>{unit_from_texture(uv.y, height) * atmosphere.top_altitude,
                             T(2) * unit_from_texture(uv.x, width) - T(1)};
}

}  // namespace airlight
