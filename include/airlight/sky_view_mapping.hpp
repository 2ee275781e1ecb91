#pragma once

// Where the tables of one frame keep what: the sky around an eye, and the air in front of a camera.

#include <airlight/table_mapping.hpp>

namespace airlight {

/// A direction around an eye, the sun ahead.
template <typename T>
struct SkyDirection {
    T mu;                 ///< [1] cosine between the view and the vertical
    T azimuth_cosine;     ///< [1] of the angle between view and sun over the ground, 1 towards the sun
    bool reaches_ground;  ///< whether the view ends on the ground sphere
};

/// A point in front of a camera.
template <typename T>
struct FroxelPoint {
    vec2<T> screen;  ///< [1] in [0, 1]
    T distance;      ///< [L] from the camera
};

/// Froxels whose slices are evenly far apart.
inline constexpr int slices_linear = 0;
/// Froxels whose slices crowd close to the camera: the distance is the square of the depth.
inline constexpr int slices_quadratic = 1;

/// Cosine of the angle, over the ground, between a view and the sun.
///
/// Units:    up, direction and to_sun unit vectors; result [1].
/// Domain:   unit vectors, to rounding.
/// Accuracy: 8 roundoffs of 1.
/// Errors:   1 where the view or the sun is vertical and no such angle exists.
/// Source:   definition.
template <typename T>
T sun_azimuth_cosine(const vec3<T>& up, const vec3<T>& direction, const vec3<T>& to_sun) {
    const vec3<T> view = cross_of_unit_vectors(up, direction);
    const vec3<T> sun = cross_of_unit_vectors(up, to_sun);
    const T lengths = glm::sqrt(dot_product(view, view)) * glm::sqrt(dot_product(sun, sun));
    return lengths > T(0) ? table_cosine(dot_product(view, sun) / lengths) : T(1);
}

/// The direction with these cosines, on one of the two sides of the sun, which look alike.
///
/// Units:    up and to_sun unit vectors; mu and azimuth_cosine [1]; result a unit vector.
/// Domain:   cosines in [-1, 1].
/// Accuracy: 8 roundoffs.
/// Errors:   a vertical sun stands for one ahead in some direction.
/// Source:   definition.
template <typename T>
vec3<T> sky_direction(const vec3<T>& up, const vec3<T>& to_sun, T mu, T azimuth_cosine) {
    // Any axis that is not along up replaces a sun that is.
    const vec3<T> across_sun = cross_of_unit_vectors(up, to_sun);
    const T axis_x = glm::abs(up.x) < T(0.5) ? T(1) : T(0);
    const vec3<T> across_axis = glm::cross(up, vec3<T>(axis_x, T(1) - axis_x, T(0)));
    const bool vertical = dot_product(across_sun, across_sun) <= T(0);
    const T of_sun = vertical ? T(0) : T(1);
    const vec3<T> across = of_sun * across_sun + (T(1) - of_sun) * across_axis;
    const vec3<T> side = across / glm::sqrt(dot_product(across, across));
    const vec3<T> ahead = glm::cross(side, up);

    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    const T aside = safe_sqrt((T(1) - azimuth_cosine) * (T(1) + azimuth_cosine));
    return mu * up + sine * (azimuth_cosine * ahead + aside * side);
}

/// Where the sky around an eye is read: x is the azimuth from the sun, y the height, 0 up and 1 down, with
/// texels crowding at the sun and on both sides of the horizon.
///
///     x = sqrt((1 - azimuth_cosine) / 2)
///     y = 1/2 - sqrt(1 - sin(z / 2) / sin(z_h / 2)) / 2      above the horizon at zenith angle z_h
///     y = 1/2 + sqrt(1 - sin(n / 2) / sin(n_h / 2)) / 2      on the ground, n = pi - z from the nadir
///
/// Hillaire has the angles themselves; sines of half the angles are as even at the zenith and at the
/// horizon, and need only square roots. He filters across the horizon, this does not.
///
/// Units:    altitude [L]; mu and azimuth_cosine [1]; width and height in texels; result [1], in [0, 1].
/// Domain:   altitude below the ground counts as 0; every cosine; width and height >= 1, height even.
/// Accuracy: 8 roundoffs, and the root of those that mu and the horizon's cosine have.
/// Errors:   none.
/// Source:   after Hillaire, UnrealEngineSkyAtmosphere (2020), RenderSkyCommon.hlsl; see
///           docs/decisions/0014-sky-view-without-angles.md.
template <typename T>
vec2<T> sky_view_uv(T ground_radius, T altitude, T mu, T azimuth_cosine, bool reaches_ground, int width,
                    int height) {
    const T above = glm::max(T(0), altitude);
    const T horizon = horizon_cosine(ground_radius, above);
    // Squares of the half angles' sines, twice.
    const T below_horizon = cosines_below_horizon(ground_radius, above, horizon);
    const T to_horizon = reaches_ground ? below_horizon : T(1) - horizon;
    const T to_view = reaches_ground ? T(1) + table_cosine(mu) : T(1) - table_cosine(mu);
    const T gone = reaches_ground ? horizon - mu : mu - horizon;
    const T y = glm::sqrt(share_of(gone, to_horizon + glm::sqrt(to_horizon * to_view)));
    const T x = glm::sqrt(share_of(T(1) - azimuth_cosine, T(2)));
    return vec2<T>(texture_from_unit(x, width), texture_from_halves(y, reaches_ground, height));
}

/// The inverse of sky_view_uv.
///
/// Units:    altitude [L]; uv [1]; width and height in texels.
/// Domain:   altitude below the ground counts as 0; every uv; width and height >= 1, height even.
/// Accuracy: 8 roundoffs of the size.
/// Errors:   none.
/// Source:   as sky_view_uv.
template <typename T>
SkyDirection<T> sky_view_parameters(T ground_radius, T altitude, const vec2<T>& uv, int width, int height) {
    const T above = glm::max(T(0), altitude);
    const T horizon = horizon_cosine(ground_radius, above);
    const bool reaches_ground = uv.y > T(0.5);
    const T below_horizon = cosines_below_horizon(ground_radius, above, horizon);
    const T to_horizon = reaches_ground ? below_horizon : T(1) - horizon;
    const T y = unit_from_halves(uv.y, height);
    const T gone = to_horizon * (y * y) * (T(2) - y * y);
    const T mu = reaches_ground ? horizon - gone : horizon + gone;
    const T x = unit_from_texture(uv.x, width);
    return SkyDirection<T>{table_cosine(mu), T(1) - T(2) * x * x, reaches_ground};
}

/// Where the air in front of a camera is read: x and y over the screen, z the depth. The first slice is at
/// the camera itself, where there is no air yet, the last one at max_distance.
///
/// Units:    screen [1], in [0, 1]; distances [L]; sizes in texels; result [1], in [0, 1].
/// Domain:   every distance, beyond max_distance counts as there; slices is slices_linear or
///           slices_quadratic; sizes >= 1.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   squares as in Hillaire, UnrealEngineSkyAtmosphere (2020), RenderSkyRayMarching.hlsl.
template <typename T>
vec3<T> froxel_uvw(const vec2<T>& screen, T distance, T max_distance, int slices, int width, int height,
                   int depth) {
    const T share = share_of(glm::min(distance, max_distance), max_distance);
    const T z = slices == slices_quadratic ? glm::sqrt(share) : share;
    return vec3<T>(texture_from_unit(screen.x, width), texture_from_unit(screen.y, height),
                   texture_from_unit(z, depth));
}

/// The inverse of froxel_uvw.
///
/// Units:    uvw [1]; max_distance [L]; sizes in texels.
/// Domain:   every uvw; slices is slices_linear or slices_quadratic; sizes >= 1.
/// Accuracy: 4 roundoffs of the size.
/// Errors:   none.
/// Source:   as froxel_uvw.
template <typename T>
FroxelPoint<T> froxel_parameters(const vec3<T>& uvw, T max_distance, int slices, int width, int height,
                                 int depth) {
    const T z = unit_from_texture(uvw.z, depth);
    const T share = slices == slices_quadratic ? z * z : z;
    return FroxelPoint<T>{vec2<T>(unit_from_texture(uvw.x, width), unit_from_texture(uvw.y, height)),
                          share * max_distance};
}

}  // namespace airlight
