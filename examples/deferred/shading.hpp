#pragma once

#include <airlight/airlight.hpp>

#include "frame.hpp"
#include "tables.hpp"

// What a pixel shows, from what the G-buffer holds. shaders/shading.glsl says the same in GLSL, function by
// function; only the air differs: here the library's headers, there the GLSL generated from them.

namespace deferred {

/// A pixel of the G-buffer.
struct Surface {
    float depth;  ///< near_distance / distance along the view axis; 0 where there is no surface
    vec3 albedo;
    float roughness;  ///< 1 mirrors nothing, 1/3 and less mirrors as water does, ever sharper
    vec3 normal;
    float sun_share;  ///< of the sun that it sees past what stands in the way
    float sky_share;  ///< of its sky
};

inline vec3 unit(const vec3& v) {
    return v / glm::sqrt(airlight::dot_product(v, v));
}

inline vec3 pixel_ray(const Frame& frame, int x, int y) {
    return frame.ray_corner + (float(x) + 0.5f) * frame.ray_across + (float(y) + 0.5f) * frame.ray_up;
}

/// Share of light that a water surface mirrors (Schlick 1994), cosine between the light and the normal.
inline float mirrored_share(float cosine) {
    const float m = 1 - glm::clamp(cosine, 0.0f, 1.0f);
    return 0.02f + 0.98f * ((m * m) * (m * m) * m);
}

/// Sunlight mirrored by small facets: distribution of Trowbridge and Reitz, masking after Hammon (2017).
/// Radiance per irradiance of the surface [1/sr].
inline float sun_glint(const Surface& surface, const vec3& normal, const vec3& to_eye, const vec3& to_sun) {
    const float a = surface.roughness * surface.roughness;
    const vec3 half_way = unit(to_eye + to_sun);
    const float cosine = airlight::dot_product(normal, half_way);
    // Written with the sine: 1 - cosine^2 has no digits left where the glint is brightest.
    const vec3 across = glm::cross(normal, half_way);
    const float spread = a * a * cosine * cosine + airlight::dot_product(across, across);
    const float distribution = a * a / (airlight::pi<float> * spread * spread);
    const float n_eye = glm::max(airlight::dot_product(normal, to_eye), 1e-3f);
    const float n_sun = glm::max(airlight::dot_product(normal, to_sun), 1e-3f);
    const float masking = 0.5f / (2 * n_eye * n_sun * (1 - a) + (n_eye + n_sun) * a);
    return distribution * masking * mirrored_share(airlight::dot_product(to_sun, half_way));
}

/// The same after Phong, as sharp at its middle: a lobe around the mirrored sun.
inline float phong_glint(const Surface& surface, const vec3& normal, const vec3& to_eye, const vec3& to_sun) {
    const float a = surface.roughness * surface.roughness;
    const float shininess = glm::max(2 / (a * a) - 2, 1.0f);
    const float n_sun = airlight::dot_product(normal, to_sun);
    const vec3 mirrored = 2 * n_sun * normal - to_sun;
    const float cosine = glm::max(airlight::dot_product(mirrored, to_eye), 1e-30f);
    return (shininess + 2) / (2 * airlight::pi<float>)*glm::exp(shininess * glm::log(cosine)) *
           mirrored_share(n_sun);
}

/// The light of single scattering and what a table of light from all sides adds.
template <typename Scene, typename Light>
airlight::Scattered<float> all_light(const airlight::Atmosphere<float>& air, const Frame& frame,
                                     const airlight::Viewpoint<float>& eye, const vec3& direction,
                                     float distance, int steps, const Light& light) {
    if (frame.marched != 0) {
        airlight::Scattered<float> once = airlight::single_scattering_marched<float, Scene>(
            air, eye, direction, frame.to_sun, distance, steps);
        once.radiance += airlight::diffuse_scattering_marched<float, Scene>(air, eye, direction, frame.to_sun,
                                                                            distance, steps, light);
        return once;
    }
    return airlight::all_scattering<float, Scene>(air, eye, direction, frame.to_sun, distance, light);
}

template <typename Scene, typename Shape>
airlight::Scattered<float> table_light(const Shape& shape, const AirTables& tables, const Frame& frame,
                                       const airlight::Viewpoint<float>& eye, const vec3& direction,
                                       float distance) {
    using Hook = airlight::TableHook<float, Shape>;
    const airlight::ScatteringTables<float>& t = tables.scattering;
    return airlight::scattering_of_table<float, Scene>(shape.atmosphere, eye, direction, frame.to_sun,
                                                       distance, Hook{shape, t.rayleigh}, Hook{shape, t.mie},
                                                       Hook{shape, t.multiple});
}

/// The air's light, by the frame's method and the tables.
template <typename Scene>
airlight::Scattered<float> air_light(const airlight::Atmosphere<float>& air, const Frame& frame,
                                     const AirTables& tables, const airlight::Viewpoint<float>& eye,
                                     const vec3& direction, float distance, int steps) {
    switch (tables.kind) {
        case TableKind::inscatter3d:
            return table_light<Scene>(tables.inscatter_shape, tables, frame, eye, direction, distance);
        case TableKind::bruneton:
            return table_light<Scene>(tables.bruneton_shape, tables, frame, eye, direction, distance);
        case TableKind::hillaire:
            return all_light<Scene>(air, frame, eye, direction, distance, steps,
                                    airlight::HillaireLight<float>{&air, &tables.hillaire});
        case TableKind::diffuse:
            return all_light<Scene>(air, frame, eye, direction, distance, steps, tables.diffuse);
        case TableKind::transmittance:
        case TableKind::none:
            break;
    }
    if (frame.marched == 0) {
        return airlight::single_scattering<float, Scene>(air, eye, direction, frame.to_sun, distance);
    }
    if (tables.kind == TableKind::transmittance) {
        return airlight::single_scattering_marched<float, Scene>(
            air, eye, direction, frame.to_sun, distance, steps, airlight::AlwaysLit{},
            airlight::SlantTransmittance<float, Scene>{&tables.slants});
    }
    return airlight::single_scattering_marched<float, Scene>(air, eye, direction, frame.to_sun, distance,
                                                             steps);
}

/// The sky's light on a surface as even radiance [1/sr]. Without a table of irradiance the whole sky stands
/// in for one look along the normal.
inline vec3 sky_light(const Frame& frame, const AirTables& tables, const airlight::Viewpoint<float>& here,
                      const vec3& normal, const vec3& sky) {
    if (tables.kind != TableKind::diffuse) {
        return sky;
    }
    const float mu_s = glm::clamp(airlight::dot_product(here.up, frame.to_sun), -1.0f, 1.0f);
    return airlight::sky_irradiance_on(airlight::sky_irradiance(tables.diffuse, here.altitude, mu_s),
                                       glm::clamp(airlight::dot_product(normal, here.up), -1.0f, 1.0f), mu_s,
                                       airlight::dot_product(normal, frame.to_sun)) /
           airlight::pi<float>;
}

/// Lommel and Seeliger: dust without a sheen, as bright at its edge as in its middle. A factor of Lambert's
/// radiance, 1 where the sun is behind the eye and straight above.
inline float lommel_seeliger(float n_sun, float n_eye) {
    return 2 / (glm::max(n_sun, 0.0f) + glm::max(n_eye, 0.0f) + 1e-3f);
}

/// Light that leaves the surface for the eye, by unit solar irradiance above the air [1/sr].
template <typename Scene>
vec3 surface_radiance(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                      const AirTables& tables, const Surface& surface, const vec3& position,
                      const vec3& direction) {
    const vec3 origin_up(0, 0, 1);
    const airlight::Viewpoint<float> here =
        airlight::viewpoint_from_surface(atmosphere.ground_radius, position, origin_up);
    const vec3 normal = unit(surface.normal);
    const float n_sun = airlight::dot_product(normal, frame.to_sun);
    vec3 sunlight(glm::max(n_sun, 0.0f));
    vec3 sky(0);
    vec3 skylight(0);
    if (frame.air != 0) {
        sunlight = airlight::sun_irradiance<float, Scene>(atmosphere, here, normal, frame.to_sun,
                                                          frame.sun_sin_radius);
        sky = air_light<Scene>(atmosphere, frame, tables, here, normal, airlight::no_surface<float>(),
                               frame.sky_steps)
                  .radiance;
        skylight = surface.sky_share * sky_light(frame, tables, here, normal, sky);
    }
    sunlight *= surface.sun_share;
    const float shade =
        frame.lommel_seeliger != 0 ? lommel_seeliger(n_sun, airlight::dot_product(normal, -direction)) : 1.0f;
    vec3 radiance = surface.albedo * (sunlight * (shade / airlight::pi<float>)+skylight);
    if (surface.roughness < 1) {
        const float polish = glm::min(1.5f * (1 - surface.roughness), 1.0f);
        const float glint = frame.phong != 0 ? phong_glint(surface, normal, -direction, frame.to_sun)
                                             : sun_glint(surface, normal, -direction, frame.to_sun);
        radiance +=
            polish * (sunlight * glint +
                      sky * (surface.sky_share * mirrored_share(airlight::dot_product(normal, -direction))));
    }
    return radiance;
}

/// The sun itself, above the air [1/sr].
inline vec3 sun_disc(const Frame& frame, const vec3& direction) {
    airlight::SunDisc<float> sun = airlight::solar_disc<float>();
    sun.sin_radius = frame.sun_sin_radius;
    sun.sin_edge = frame.sun_sin_edge;
    return airlight::sun_radiance(sun, direction, frame.to_sun);
}

/// How far the surface of a depth is along the pixel's ray.
inline float surface_distance(const Frame& frame, float depth, float ray_length) {
    return depth > 0 ? frame.near_distance / depth * ray_length : airlight::no_surface<float>();
}

/// What the pixel would show without the air in front of it, by unit solar irradiance [1/sr].
template <typename Scene>
vec3 light_behind_air(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                      const AirTables& tables, const Surface& surface, int x, int y) {
    const vec3 ray = pixel_ray(frame, x, y);
    const float ray_length = glm::sqrt(airlight::dot_product(ray, ray));
    const vec3 direction = ray / ray_length;
    if (surface.depth > 0) {
        const vec3 position =
            frame.eye_position + direction * surface_distance(frame, surface.depth, ray_length);
        return surface_radiance<Scene>(atmosphere, frame, tables, surface, position, direction);
    }
    return sun_disc(frame, direction);
}

/// What the pixel shows, in units of solar_irradiance per sr: what is behind the air, through it, and the
/// air's own light less what shadows keep from it.
template <typename Scene>
vec3 light_through_air(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                       const AirTables& tables, float depth, const vec3& behind, const vec3& lost, int x,
                       int y) {
    const vec3 ray = pixel_ray(frame, x, y);
    const float ray_length = glm::sqrt(airlight::dot_product(ray, ray));
    const vec3 direction = ray / ray_length;
    if (frame.air == 0) {
        return behind * frame.solar_irradiance;
    }
    const vec3 origin_up(0, 0, 1);
    const airlight::Viewpoint<float> eye =
        airlight::viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
    airlight::Scattered<float> scattered = air_light<Scene>(
        atmosphere, frame, tables, eye, direction, surface_distance(frame, depth, ray_length), frame.steps);
    scattered.radiance = glm::max(scattered.radiance - lost, vec3(0));
    return airlight::compose(behind * frame.solar_irradiance, scattered, frame.solar_irradiance);
}

}  // namespace deferred
