// What a pixel shows, from what the G-buffer holds: shading.hpp in GLSL, function by function.
#include "airlight/atmosphere.glsl"

#include "tables.glsl"

#include "airlight/aerial_perspective.glsl"
#include "airlight/compose.glsl"
#include "airlight/constants.glsl"
#include "airlight/multiple_scattering.glsl"
#include "airlight/scattering_of_table.glsl"
#include "airlight/single_scattering.glsl"
#include "airlight/sky_irradiance.glsl"
#include "airlight/sun.glsl"
#include "airlight/viewpoint.glsl"

#include "frame.glsl"

struct Surface {
    float depth;
    vec3 albedo;
    float roughness;
    vec3 normal;
    float sun_share;
    float sky_share;
};

vec3 unit(vec3 v) {
    return v / sqrt(airlight_dot_product(v, v));
}

float mirrored_share(float cosine) {
    float m = 1.0 - clamp(cosine, 0.0, 1.0);
    return 0.02 + 0.98 * ((m * m) * (m * m) * m);
}

float sun_glint(Surface surface, vec3 normal, vec3 to_eye, vec3 to_sun) {
    float a = surface.roughness * surface.roughness;
    vec3 half_way = unit(to_eye + to_sun);
    float cosine = airlight_dot_product(normal, half_way);
    vec3 across = cross(normal, half_way);
    float spread = a * a * cosine * cosine + airlight_dot_product(across, across);
    float distribution = a * a / (airlight_pi * spread * spread);
    float n_eye = max(airlight_dot_product(normal, to_eye), 1e-3);
    float n_sun = max(airlight_dot_product(normal, to_sun), 1e-3);
    float masking = 0.5 / (2.0 * n_eye * n_sun * (1.0 - a) + (n_eye + n_sun) * a);
    return distribution * masking * mirrored_share(airlight_dot_product(to_sun, half_way));
}

float phong_glint(Surface surface, vec3 normal, vec3 to_eye, vec3 to_sun) {
    float a = surface.roughness * surface.roughness;
    float shininess = max(2.0 / (a * a) - 2.0, 1.0);
    float n_sun = airlight_dot_product(normal, to_sun);
    vec3 mirrored = 2.0 * n_sun * normal - to_sun;
    float cosine = max(airlight_dot_product(mirrored, to_eye), 1e-30);
    return (shininess + 2.0) / (2.0 * airlight_pi) * exp(shininess * log(cosine)) *
           mirrored_share(airlight_dot_product(to_sun, unit(to_eye + to_sun)));
}

struct Light {
    vec3 direction;
    float irradiance;
    float sin_radius;
};

Light light_of(Frame frame, int i) {
    return i == 0 ? Light(frame.to_sun, frame.sun_seen, frame.sun_sin_radius)
                  : Light(frame.to_moon, frame.moon_irradiance, frame.moon_sin_radius);
}

airlight_Scattered air_light(airlight_Atmosphere air, Frame frame, airlight_Viewpoint eye, vec3 direction,
                             vec3 to_light, float distance, int steps) {
#if TABLES == TABLES_INSCATTER3D || TABLES == TABLES_BRUNETON
    return airlight_scattering_of_table(air, eye, direction, to_light, distance);
#else
    if (frame.marched) {
        airlight_Scattered once =
            airlight_single_scattering_marched(air, eye, direction, to_light, distance, steps);
#if TABLES == TABLES_HILLAIRE || TABLES == TABLES_DIFFUSE
        once.radiance +=
            airlight_diffuse_scattering_marched(air, eye, direction, to_light, distance, steps);
#endif
        return once;
    }
#if TABLES == TABLES_HILLAIRE || TABLES == TABLES_DIFFUSE
    return airlight_all_scattering(air, eye, direction, to_light, distance);
#else
    return airlight_single_scattering(air, eye, direction, to_light, distance);
#endif
#endif
}

// Without a table of irradiance the whole sky stands in for one look along the normal.
vec3 sky_light(airlight_Viewpoint here, vec3 normal, vec3 to_light, vec3 sky) {
#if TABLES == TABLES_DIFFUSE
    float mu_s = clamp(airlight_dot_product(here.up, to_light), -1.0, 1.0);
    return airlight_sky_irradiance_on(light_on_surfaces(here.altitude, mu_s),
                                      clamp(airlight_dot_product(normal, here.up), -1.0, 1.0), mu_s,
                                      airlight_dot_product(normal, to_light)) /
           airlight_pi;
#else
    return sky;
#endif
}

// Lommel and Seeliger: dust without a sheen, as bright at its edge as in its middle; as bright as Lambert's where
// the sun is behind the eye.
float lommel_seeliger(float n_sun, float n_eye) {
    return 2.0 / (max(n_sun, 0.0) + max(n_eye, 0.0) + 1e-3);
}

vec3 radiance_by_light(airlight_Atmosphere atmosphere, Frame frame, Surface surface, Light light, float seen,
                       vec3 position, vec3 direction) {
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    airlight_Viewpoint here = airlight_viewpoint_from_surface(atmosphere.ground_radius, position, origin_up);
    vec3 normal = unit(surface.normal);
    float n_sun = airlight_dot_product(normal, light.direction);
    vec3 sunlight = vec3(max(n_sun, 0.0));
    vec3 sky = vec3(0.0);
    vec3 skylight = vec3(0.0);
    if (frame.air) {
        sunlight = airlight_sun_irradiance(atmosphere, here, normal, light.direction, light.sin_radius);
        sky = air_light(atmosphere, frame, here, normal, light.direction, airlight_no_surface(), frame.sky_steps)
                  .radiance;
        skylight = surface.sky_share * sky_light(here, normal, light.direction, sky);
    }
    sunlight *= seen;
    float shade = frame.lommel_seeliger
                      ? lommel_seeliger(n_sun, airlight_dot_product(normal, -direction))
                      : 1.0;
    vec3 radiance = surface.albedo * (sunlight * (shade / airlight_pi) + skylight);
    if (surface.roughness < 1.0) {
        float polish = min(1.5 * (1.0 - surface.roughness), 1.0);
        float glint = frame.phong ? phong_glint(surface, normal, -direction, light.direction)
                                  : sun_glint(surface, normal, -direction, light.direction);
        radiance += polish * (sunlight * glint +
                              sky * (surface.sky_share * mirrored_share(airlight_dot_product(normal, -direction))));
    }
    return radiance;
}

vec3 surface_radiance(airlight_Atmosphere atmosphere, Frame frame, Surface surface, vec3 position,
                      vec3 direction) {
    vec3 radiance = vec3(0.0);
    for (int i = 0; i < frame.lights; ++i) {
        Light light = light_of(frame, i);
        float seen = i == frame.mapped_light ? surface.sun_share : 1.0;
        radiance += light.irradiance *
                    radiance_by_light(atmosphere, frame, surface, light, seen, position, direction);
    }
    return radiance;
}

vec3 sun_disc(Frame frame, vec3 direction) {
    airlight_SunDisc sun = airlight_solar_disc();
    sun.sin_radius = frame.sun_sin_radius;
    sun.sin_edge = frame.sun_sin_edge;
    return airlight_sun_radiance(sun, direction, frame.to_sun);
}

float moon_share(Frame frame, vec3 direction) {
    if (frame.lights < 2 || airlight_dot_product(direction, frame.to_moon) <= 0.0) {
        return 0.0;
    }
    vec3 across = airlight_cross_of_unit_vectors(direction, frame.to_moon);
    float sine = sqrt(airlight_dot_product(across, across));
    float edge = min(frame.sun_sin_edge, frame.moon_sin_radius);
    return clamp(0.5 + (frame.moon_sin_radius - sine) / (2.0 * edge), 0.0, 1.0);
}

vec3 moon_radiance(Frame frame, vec3 direction) {
    vec3 across = airlight_cross_of_unit_vectors(direction, frame.to_moon);
    float r = frame.moon_sin_radius;
    float n_eye = sqrt(max(1.0 - airlight_dot_product(across, across) / (r * r), 0.0));
    vec3 normal = cross(frame.to_moon, across) / r - n_eye * frame.to_moon;
    float n_sun = max(airlight_dot_product(normal, frame.to_sun), 0.0);
    float grain_albedo = 8.0 * 0.12;
    return vec3(grain_albedo / (4.0 * airlight_pi) * (n_sun / (n_sun + n_eye + 1e-6)));
}

vec3 space_radiance(Frame frame, vec3 stars, vec3 direction, float ray_length) {
    float narrower = ray_length * ray_length * ray_length;
    vec3 beyond = stars * (frame.star_radiance * narrower) + sun_disc(frame, direction);
    float share = moon_share(frame, direction);
    return share > 0.0 ? beyond * (1.0 - share) + moon_radiance(frame, direction) * share : beyond;
}

// How far the surface of a depth is along the pixel's ray.
float surface_distance(Frame frame, float depth, float ray_length) {
    return depth > 0.0 ? frame.near_distance / depth * ray_length : airlight_no_surface();
}

vec3 light_behind_air(airlight_Atmosphere atmosphere, Frame frame, Surface surface, ivec2 pixel) {
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = sqrt(airlight_dot_product(ray, ray));
    vec3 direction = ray / ray_length;
    if (surface.depth > 0.0) {
        vec3 position =
            frame.eye_position + direction * surface_distance(frame, surface.depth, ray_length);
        return surface_radiance(atmosphere, frame, surface, position, direction);
    }
    return space_radiance(frame, surface.albedo, direction, ray_length);
}

airlight_Scattered air_in_front(airlight_Atmosphere atmosphere, Frame frame, vec3 direction, float distance,
                                vec3 lost) {
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    airlight_Viewpoint eye =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
    airlight_Scattered scattered = airlight_Scattered(vec3(0.0), vec3(1.0));
    for (int i = 0; i < frame.lights; ++i) {
        Light light = light_of(frame, i);
        airlight_Scattered one =
            air_light(atmosphere, frame, eye, direction, light.direction, distance, frame.steps);
        vec3 radiance = i == frame.mapped_light ? max(one.radiance - lost, 0.0) : one.radiance;
        scattered.radiance += light.irradiance * radiance;
        scattered.transmittance = one.transmittance;
    }
    return scattered;
}

vec3 light_through_air(airlight_Atmosphere atmosphere, Frame frame, float depth, vec3 behind, vec3 lost,
                       ivec2 pixel) {
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = sqrt(airlight_dot_product(ray, ray));
    vec3 direction = ray / ray_length;
    if (!frame.air) {
        return behind * frame.solar_irradiance;
    }
    airlight_Scattered scattered =
        air_in_front(atmosphere, frame, direction, surface_distance(frame, depth, ray_length), lost);
    return airlight_compose(behind * frame.solar_irradiance, scattered, frame.solar_irradiance);
}

const float cloud_middle = 2000.0;  // [m]

struct Cloud {
    vec3 light;
    float transmittance;
    float distance;
};

// near + T_near cloud + T_near T_cloud rest, written without the rest.
vec3 light_through_clouds(airlight_Atmosphere atmosphere, Frame frame, float depth, vec3 behind, vec3 lost,
                          Cloud cloud, ivec2 pixel) {
    vec3 plain = light_through_air(atmosphere, frame, depth, behind, lost, pixel);
    if (cloud.transmittance >= 1.0 || !frame.air) {
        return cloud.transmittance * plain + cloud.light * frame.solar_irradiance;
    }
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    float altitude =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up).altitude;
    vec3 shadows = altitude < cloud_middle ? lost : vec3(0.0);
    airlight_Scattered near_air =
        air_in_front(atmosphere, frame, unit(pixel_ray(frame, pixel)), cloud.distance, shadows);
    return cloud.transmittance * plain +
           ((1.0 - cloud.transmittance) * near_air.radiance + near_air.transmittance * cloud.light) *
               frame.solar_irradiance;
}
