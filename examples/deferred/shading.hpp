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
    float sun_share;  ///< of the shadow maps' light that it sees past what stands in the way
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
           mirrored_share(airlight::dot_product(to_sun, unit(to_eye + to_sun)));
}

/// The light of single scattering and what a table of light from all sides adds.
template <typename Scene, typename Diffuse>
airlight::Scattered<float> all_light(const airlight::Atmosphere<float>& air, const Frame& frame,
                                     const airlight::Viewpoint<float>& eye, const vec3& direction,
                                     const vec3& to_light, float distance, int steps, const Diffuse& light) {
    if (frame.marched != 0) {
        airlight::Scattered<float> once =
            airlight::single_scattering_marched<float, Scene>(air, eye, direction, to_light, distance, steps);
        once.radiance += airlight::diffuse_scattering_marched<float, Scene>(air, eye, direction, to_light,
                                                                            distance, steps, light);
        return once;
    }
    return airlight::all_scattering<float, Scene>(air, eye, direction, to_light, distance, light);
}

template <typename Scene, typename Shape>
airlight::Scattered<float> table_light(const Shape& shape, const AirTables& tables,
                                       const airlight::Viewpoint<float>& eye, const vec3& direction,
                                       const vec3& to_light, float distance) {
    using Hook = airlight::TableHook<float, Shape>;
    const airlight::ScatteringTables<float>& t = tables.scattering;
    return airlight::scattering_of_table<float, Scene>(shape.atmosphere, eye, direction, to_light, distance,
                                                       Hook{shape, t.rayleigh}, Hook{shape, t.mie},
                                                       Hook{shape, t.multiple});
}

/// A light so far away that it comes from one direction everywhere: the sun or the moon.
struct Light {
    vec3 direction;    ///< towards it
    float irradiance;  ///< above the air; the whole sun's is 1
    float sin_radius;
};

inline Light light_of(const Frame& frame, int i) {
    return i == 0 ? Light{frame.to_sun, frame.sun_seen, frame.sun_sin_radius}
                  : Light{frame.to_moon, frame.moon_irradiance, frame.moon_sin_radius};
}

/// The air's light, by the frame's method and the tables, while one light shines with irradiance 1.
template <typename Scene>
airlight::Scattered<float> air_light(const airlight::Atmosphere<float>& air, const Frame& frame,
                                     const AirTables& tables, const airlight::Viewpoint<float>& eye,
                                     const vec3& direction, const vec3& to_light, float distance, int steps) {
    switch (tables.kind) {
        case TableKind::inscatter3d:
            return table_light<Scene>(tables.inscatter_shape, tables, eye, direction, to_light, distance);
        case TableKind::bruneton:
            return table_light<Scene>(tables.bruneton_shape, tables, eye, direction, to_light, distance);
        case TableKind::hillaire:
            return all_light<Scene>(air, frame, eye, direction, to_light, distance, steps,
                                    airlight::HillaireLight<float>{&air, &tables.hillaire});
        case TableKind::diffuse:
            return all_light<Scene>(air, frame, eye, direction, to_light, distance, steps, tables.diffuse);
        case TableKind::transmittance:
        case TableKind::none:
            break;
    }
    if (frame.marched == 0) {
        return airlight::single_scattering<float, Scene>(air, eye, direction, to_light, distance);
    }
    if (tables.kind == TableKind::transmittance) {
        return airlight::single_scattering_marched<float, Scene>(
            air, eye, direction, to_light, distance, steps, airlight::AlwaysLit{},
            airlight::SlantTransmittance<float, Scene>{&tables.slants});
    }
    return airlight::single_scattering_marched<float, Scene>(air, eye, direction, to_light, distance, steps);
}

/// The sky's light on a surface as even radiance [1/sr]. Without a table of irradiance the whole sky stands
/// in for one look along the normal.
inline vec3 sky_light(const AirTables& tables, const airlight::Viewpoint<float>& here, const vec3& normal,
                      const vec3& to_light, const vec3& sky) {
    if (tables.kind != TableKind::diffuse) {
        return sky;
    }
    const float mu_s = glm::clamp(airlight::dot_product(here.up, to_light), -1.0f, 1.0f);
    return airlight::sky_irradiance_on(airlight::sky_irradiance(tables.diffuse, here.altitude, mu_s),
                                       glm::clamp(airlight::dot_product(normal, here.up), -1.0f, 1.0f), mu_s,
                                       airlight::dot_product(normal, to_light)) /
           airlight::pi<float>;
}

/// Lommel and Seeliger: dust without a sheen, as bright at its edge as in its middle. A factor of Lambert's
/// radiance, 1 where the sun is behind the eye and straight above.
inline float lommel_seeliger(float n_sun, float n_eye) {
    return 2 / (glm::max(n_sun, 0.0f) + glm::max(n_eye, 0.0f) + 1e-3f);
}

/// Light that leaves the surface for the eye while one light, of which it sees a share, shines with
/// irradiance 1 above the air [1/sr].
template <typename Scene>
vec3 radiance_by_light(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                       const AirTables& tables, const Surface& surface, const Light& light, float seen,
                       const vec3& position, const vec3& direction) {
    const vec3 origin_up(0, 0, 1);
    const airlight::Viewpoint<float> here =
        airlight::viewpoint_from_surface(atmosphere.ground_radius, position, origin_up);
    const vec3 normal = unit(surface.normal);
    const float n_sun = airlight::dot_product(normal, light.direction);
    vec3 sunlight(glm::max(n_sun, 0.0f));
    vec3 sky(0);
    vec3 skylight(0);
    if (frame.air != 0) {
        sunlight = airlight::sun_irradiance<float, Scene>(atmosphere, here, normal, light.direction,
                                                          light.sin_radius);
        sky = air_light<Scene>(atmosphere, frame, tables, here, normal, light.direction,
                               airlight::no_surface<float>(), frame.sky_steps)
                  .radiance;
        skylight = surface.sky_share * sky_light(tables, here, normal, light.direction, sky);
    }
    sunlight *= seen;
    const float shade =
        frame.lommel_seeliger != 0 ? lommel_seeliger(n_sun, airlight::dot_product(normal, -direction)) : 1.0f;
    vec3 radiance = surface.albedo * (sunlight * (shade / airlight::pi<float>)+skylight);
    if (surface.roughness < 1) {
        const float polish = glm::min(1.5f * (1 - surface.roughness), 1.0f);
        const float glint = frame.phong != 0 ? phong_glint(surface, normal, -direction, light.direction)
                                             : sun_glint(surface, normal, -direction, light.direction);
        radiance +=
            polish * (sunlight * glint +
                      sky * (surface.sky_share * mirrored_share(airlight::dot_product(normal, -direction))));
    }
    return radiance;
}

/// Light that leaves the surface for the eye [1/sr].
template <typename Scene>
vec3 surface_radiance(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                      const AirTables& tables, const Surface& surface, const vec3& position,
                      const vec3& direction) {
    vec3 radiance(0);
    for (int i = 0; i < frame.lights; ++i) {
        const Light light = light_of(frame, i);
        const float seen = i == frame.mapped_light ? surface.sun_share : 1.0f;
        radiance += light.irradiance * radiance_by_light<Scene>(atmosphere, frame, tables, surface, light,
                                                                seen, position, direction);
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

/// The share of a pixel that the moon's disc covers. Its rim is spread as the sun's, but no further than
/// makes a cone of the disc.
inline float moon_share(const Frame& frame, const vec3& direction) {
    if (frame.lights < 2 || airlight::dot_product(direction, frame.to_moon) <= 0) {
        return 0;
    }
    const vec3 across = airlight::cross_of_unit_vectors(direction, frame.to_moon);
    const float sine = glm::sqrt(airlight::dot_product(across, across));
    const float edge = glm::min(frame.sun_sin_edge, frame.moon_sin_radius);
    return glm::clamp(0.5f + (frame.moon_sin_radius - sine) / (2 * edge), 0.0f, 1.0f);
}

/// The moon's surface [1/sr]: dust after Lommel and Seeliger, equally bright all over when full. Its
/// geometric albedo is 0.12, which is an eighth of the albedo of a grain.
inline vec3 moon_radiance(const Frame& frame, const vec3& direction) {
    const vec3 across = airlight::cross_of_unit_vectors(direction, frame.to_moon);
    const float r = frame.moon_sin_radius;
    const float n_eye = glm::sqrt(glm::max(1 - airlight::dot_product(across, across) / (r * r), 0.0f));
    const vec3 normal = glm::cross(frame.to_moon, across) / r - n_eye * frame.to_moon;
    const float n_sun = glm::max(airlight::dot_product(normal, frame.to_sun), 0.0f);
    const float grain_albedo = 8 * 0.12f;
    return vec3(grain_albedo / (4 * airlight::pi<float>)*(n_sun / (n_sun + n_eye + 1e-6f)));
}

/// The sky behind the air [1/sr]: stars, the sun, and the moon in front of both. `stars` is in units of one
/// of magnitude 0.
inline vec3 space_radiance(const Frame& frame, const vec3& stars, const vec3& direction, float ray_length) {
    // The further from the middle, the less sky a pixel shows.
    const float narrower = ray_length * ray_length * ray_length;
    const vec3 beyond = stars * (frame.star_radiance * narrower) + sun_disc(frame, direction);
    const float share = moon_share(frame, direction);
    return share > 0 ? beyond * (1 - share) + moon_radiance(frame, direction) * share : beyond;
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
    return space_radiance(frame, surface.albedo, direction, ray_length);
}

/// The air's light from the eye to a distance, of all lights, less what shadows keep from one of them.
template <typename Scene>
airlight::Scattered<float> air_in_front(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                                        const AirTables& tables, const vec3& direction, float distance,
                                        const vec3& lost) {
    const vec3 origin_up(0, 0, 1);
    const airlight::Viewpoint<float> eye =
        airlight::viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
    airlight::Scattered<float> scattered{vec3(0), vec3(1)};
    for (int i = 0; i < frame.lights; ++i) {
        const Light light = light_of(frame, i);
        const airlight::Scattered<float> one = air_light<Scene>(atmosphere, frame, tables, eye, direction,
                                                                light.direction, distance, frame.steps);
        const vec3 radiance = i == frame.mapped_light ? glm::max(one.radiance - lost, vec3(0)) : one.radiance;
        scattered.radiance += light.irradiance * radiance;
        scattered.transmittance = one.transmittance;
    }
    return scattered;
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
    const airlight::Scattered<float> scattered = air_in_front<Scene>(
        atmosphere, frame, tables, direction, surface_distance(frame, depth, ray_length), lost);
    return airlight::compose(behind * frame.solar_irradiance, scattered, frame.solar_irradiance);
}

inline constexpr float cloud_middle = 2000;  // [m] as in shaders/clouds.glsl

/// What there is of clouds in front of a pixel.
struct Cloud {
    vec3 light;           ///< [1/sr] theirs, without the air in front of them
    float transmittance;  ///< 1 without clouds
    float distance;       ///< [m]
};

/// The same with clouds in the air.
///
///     near + T_near cloud + T_near T_cloud rest = T_cloud whole + (1 - T_cloud) near + T_near cloud
///
/// The right side has no seam where clouds begin, and wants only air that starts at the eye.
template <typename Scene>
vec3 light_through_clouds(const airlight::Atmosphere<float>& atmosphere, const Frame& frame,
                          const AirTables& tables, float depth, const vec3& behind, const vec3& lost,
                          const Cloud& cloud, int x, int y) {
    const vec3 plain = light_through_air<Scene>(atmosphere, frame, tables, depth, behind, lost, x, y);
    if (cloud.transmittance >= 1 || frame.air == 0) {
        return cloud.transmittance * plain + cloud.light * frame.solar_irradiance;
    }
    // Shadows of the landscape lie below the clouds: in front of them for an eye down there only.
    const vec3 origin_up(0, 0, 1);
    const float altitude =
        airlight::viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up).altitude;
    const vec3 shadows = altitude < cloud_middle ? lost : vec3(0);
    const airlight::Scattered<float> near_air =
        air_in_front<Scene>(atmosphere, frame, tables, unit(pixel_ray(frame, x, y)), cloud.distance, shadows);
    return cloud.transmittance * plain +
           ((1 - cloud.transmittance) * near_air.radiance + near_air.transmittance * cloud.light) *
               frame.solar_irradiance;
}

}  // namespace deferred
