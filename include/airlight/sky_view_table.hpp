#pragma once

// The sky around one eye in one picture, baked anew when the eye or the sun has moved. Sky and ground have a
// half of the picture each, so nothing is filtered across the horizon.

#include <airlight/multiple_scattering.hpp>
#include <airlight/sky_view_mapping.hpp>

namespace airlight {

/// The scene of a sky view: the vertical is z, the sun stands over x.
template <typename T>
struct SkyRay {
    Viewpoint<T> eye;   ///< over the z axis
    vec3<T> direction;  ///< unit vector
    vec3<T> to_sun;     ///< unit vector
    T distance;         ///< [L] at which the view ends at the latest
};

/// The ray of a texel. Whether it ends on the ground is what the table says, not what rounding makes of a ray
/// that grazes the horizon: one past it is lifted by past_the_horizon, one to the ground ends there at the
/// latest.
///
/// Units:    altitude [L]; mu_s [1], cosine between the sun and the vertical; lengths of the result [L].
/// Domain:   every altitude, below the ground it counts as 0; mu_s in [-1, 1]; seen is sky_view_parameters'.
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   sky_direction.
template <typename T>
SkyRay<T> sky_view_ray(const Atmosphere<T>& atmosphere, T altitude, T mu_s, const SkyDirection<T>& seen) {
    const T radius = atmosphere.ground_radius;
    const T above = glm::max(altitude, T(0));
    const vec3<T> up = vec3<T>(T(0), T(0), T(1));
    const vec3<T> to_sun = sun_over_x(mu_s);
    const T horizon = horizon_cosine(radius, above);
    const T past = table_cosine(glm::max(seen.mu, horizon + past_the_horizon<T>));
    const T mu = seen.reaches_ground ? glm::min(seen.mu, horizon) : past;
    const T distance = seen.reaches_ground ? horizon_distance(radius, above) : no_surface<T>();
    return SkyRay<T>{Viewpoint<T>{above, up}, sky_direction(up, to_sun, mu, seen.azimuth_cosine), to_sun,
                     distance};
}

/// What a texel of a sky view holds: the radiance of the air along its ray.
///
/// Units:    those of sky_view_ray; result [1/sr] per unit of solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   that of sky_view_ray.
/// Accuracy: that of all_scattering.
/// Errors:   none.
/// Source:   all_scattering.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename Visibility = AlwaysLit>
vec3<T> sky_view_texel(const Atmosphere<T>& atmosphere, T altitude, T mu_s, const SkyDirection<T>& seen,
                       const MultipleScattering& multiple_scattering = MultipleScattering{},
                       const Visibility& visibility = Visibility{}) {
    const SkyRay<T> ray = sky_view_ray(atmosphere, altitude, mu_s, seen);
    const Scattered<T> light = all_scattering<T, Scene>(atmosphere, ray.eye, ray.direction, ray.to_sun,
                                                        ray.distance, multiple_scattering, visibility);
    return light.radiance;
}

/// Where the sky in a direction is read.
///
/// Units:    altitude [L] of the eye; up, direction and to_sun unit vectors; width and height in texels;
///           result [1], in [0, 1].
/// Domain:   the eye for which the table was baked; width and height >= 1, height even.
/// Accuracy: that of sky_view_uv.
/// Errors:   none.
/// Source:   sky_view_uv; the ground as view_path sees it.
template <typename T>
vec2<T> sky_view_place(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                       const vec3<T>& to_sun, int width, int height) {
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, no_surface<T>());
    return sky_view_uv(atmosphere.ground_radius, eye.altitude, dot_product(eye.up, direction),
                       sun_azimuth_cosine(eye.up, direction, to_sun), ray.reaches_ground, width, height);
}

}  // namespace airlight
