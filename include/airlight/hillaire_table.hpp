#pragma once

// All orders of scattering from the second on, after Hillaire: light that has been scattered twice is added
// up from 64 directions, as if it came alike from all sides, and every further order is taken to be the same
// share of the one before, so that their sum is a geometric series. Two dimensions, a few kilobytes.

#include <airlight/phase.hpp>
#include <airlight/planet_shadow.hpp>
#include <airlight/sun_column.hpp>
#include <airlight/table_mapping.hpp>
#include <airlight/transmittance.hpp>
#include <airlight/view_path.hpp>

namespace airlight {

/// Cosine of a share of half a turn.
///
///     cos(pi share) = sin(y),   y = pi (1 / 2 - share)
///
/// GLSL bounds the error of its own cosine far too loosely; these are seven terms of the sine's series.
///
/// Units:    share [1]; result [1].
/// Domain:   share in [0, 1].
/// Accuracy: 7e-12, plus 8 roundoffs of 1.
/// Errors:   outside the domain the series goes on and leaves [-1, 1].
/// Source:   Taylor's series.
template <typename T>
T cosine_of_half_turn(T share) {
    const T y = pi<T> * (T(0.5) - share);
    const T z = y * y;
    T sum = T(1) - z / T(210);
    sum = T(1) - z / T(156) * sum;
    sum = T(1) - z / T(110) * sum;
    sum = T(1) - z / T(72) * sum;
    sum = T(1) - z / T(42) * sum;
    sum = T(1) - z / T(20) * sum;
    sum = T(1) - z / T(6) * sum;
    return y * sum;
}

/// What one direction adds to a point: light scattered once, and the share of even light from everywhere that
/// is scattered there towards the point.
template <typename T>
struct Gathered {
    vec3<T> light;  ///< [1/sr] per unit of solar irradiance above the air, the ground's included
    vec3<T> share;  ///< [1] in [0, 1]
};

/// Sunlight at a point of the air, as shadow and air leave it.
///
/// Units:    altitude [L]; sun_height [L], of the point from the centre towards the sun; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   altitude in [0, top_altitude].
/// Accuracy: that of column_to_sun.
/// Errors:   none; 0 behind the planet, which Scene::planet_shadow may leave out.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
vec3<T> sunlight_at(const Atmosphere<T>& atmosphere, const Layers<T>& layers, T altitude, T sun_height) {
    const T radius = atmosphere.ground_radius + altitude;
    const LinePoint<T> point = line_towards_sun(altitude, radius, T(1) / radius, sun_height);
    const bool sinks = sun_height < T(0);
    if constexpr (Scene::planet_shadow) {
        if (sinks && point.perigee_altitude < T(0)) {
            return vec3<T>(T(0), T(0), T(0));
        }
    }
    const Density<T> density = layer_density<T, Scene>(layers, altitude);
    const Column<T> air = column_to_sun<T, Scene>(layers, atmosphere.ground_radius, point, sinks, density);
    return glm::exp(-column_optical_depth<T, Scene>(atmosphere, air));
}

/// What a point gets from one direction, by even steps through the air; phase functions count as isotropic.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors.
/// Domain:   an eye in the air; steps >= 1.
/// Accuracy: second order in the step.
/// Errors:   none; fewer than one step give the ground's light alone.
/// Source:   Hillaire, UnrealEngineSkyAtmosphere (2020), RenderSkyRayMarching.hlsl.
template <typename T, typename Scene = DefaultScene>
Gathered<T> gathered_along(const Atmosphere<T>& atmosphere, const Layers<T>& layers, const Viewpoint<T>& eye,
                           const vec3<T>& direction, const vec3<T>& to_sun, int steps) {
    const T radius = atmosphere.ground_radius;
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, no_surface<T>());
    const SunOverLine<T> sun = sun_over_line(radius, eye, direction, to_sun);
    const T step_length = ray.extent / glm::max(T(steps), T(1));

    vec3<T> light = vec3<T>(T(0), T(0), T(0));
    vec3<T> share = vec3<T>(T(0), T(0), T(0));
    vec3<T> seen = vec3<T>(T(1), T(1), T(1));
    for (int i = 0; i < steps; ++i) {
        const T t = (T(i) + T(0.5)) * step_length;
        const T altitude = glm::max(altitude_along_ray(radius, ray.altitude, ray.along, t), T(0));
        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        vec3<T> scattering = atmosphere.rayleigh_scattering * density.rayleigh;
        if constexpr (Scene::mie) {
            scattering += atmosphere.mie_scattering * density.mie;
        }
        const Column<T> air =
            Column<T>{step_length * density.rayleigh, step_length * density.mie, step_length * density.ozone};
        const vec3<T> depth = column_optical_depth<T, Scene>(atmosphere, air);
        const vec3<T> passed = glm::exp(-depth);
        const vec3<T> scattered = seen * (step_length * scattering) * mean_passed(depth, passed);
        const T sun_height = sun.perigee_height + (ray.along + t) * sun.cos_theta;
        light += scattered * sunlight_at<T, Scene>(atmosphere, layers, altitude, sun_height);
        share += scattered;
        seen *= passed;
    }
    light *= isotropic_phase<T>();
    if (ray.reaches_ground) {
        const T sun_height = sun.perigee_height + (ray.along + ray.extent) * sun.cos_theta;
        const T mu_s = glm::clamp(sun_height / radius, T(0), T(1));
        const vec3<T> reflected = atmosphere.ground_albedo * (mu_s / pi<T>);
        light += seen * reflected * sunlight_at<T, Scene>(atmosphere, layers, T(0), sun_height);
    }
    return Gathered<T>{light, share};
}

/// What a texel of Hillaire's table holds: the mean radiance, over all directions, of light that has been
/// scattered at least once, all orders together. Times the scattering coefficient it is the source of all
/// orders from the second on.
///
///     psi = L_2 / (1 - f),   L_2 and f the means of Gathered over the sphere
///
/// Directions lie in the middles of equal solid angles. Those on the two sides of the sun are alike, so only
/// one side is walked: 8 zeniths and 4 azimuths stand for Hillaire's 64 directions.
///
/// Units:    altitude [L]; mu_s [1], cosine between the sun and the vertical; result [1/sr] per unit of solar
///           irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   altitude in [0, top_altitude]; mu_s in [-1, 1]; zeniths, azimuths and steps >= 1.
/// Accuracy: of the method, docs/tables.md; a hundredfold gain of the series is the largest.
/// Errors:   none; no directions give 0.
/// Source:   as gathered_along.
template <typename T, typename Scene = DefaultScene>
vec3<T> hillaire_texel(const Atmosphere<T>& atmosphere, T altitude, T mu_s, int zeniths, int azimuths,
                       int steps) {
    const Layers<T> layers = layers_of<T, Scene>(atmosphere);
    const Viewpoint<T> eye = Viewpoint<T>{table_altitude(atmosphere, altitude), vec3<T>(T(0), T(0), T(1))};
    const vec3<T> to_sun = sun_over_x(mu_s);

    vec3<T> light = vec3<T>(T(0), T(0), T(0));
    vec3<T> share = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < zeniths; ++i) {
        const T mu = T(1) - (T(2) * T(i) + T(1)) / T(zeniths);
        const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
        for (int j = 0; j < azimuths; ++j) {
            const T ahead = cosine_of_half_turn((T(j) + T(0.5)) / T(azimuths));
            const T aside = safe_sqrt((T(1) - ahead) * (T(1) + ahead));
            const vec3<T> direction = vec3<T>(sine * ahead, sine * aside, mu);
            const Gathered<T> gathered =
                gathered_along<T, Scene>(atmosphere, layers, eye, direction, to_sun, steps);
            light += gathered.light;
            share += gathered.share;
        }
    }
    const T count = glm::max(T(zeniths) * T(azimuths), T(1));
    const vec3<T> least = vec3<T>(T(0.01L), T(0.01L), T(0.01L));
    return light / count / glm::max(T(1) - share / count, least);
}

}  // namespace airlight
