// The clouds in front of each pixel: their own light as seen from close by, what they let through, and how far
// away they are. Droplets scatter as aerosol does, only more, and more than once.
#include "shading.glsl"

#include "airlight/phase.glsl"
#include "airlight/transmittance.glsl"

#include "clouds.glsl"
#include "view_ray.glsl"

uniform sampler2D depth_texture;

layout(location = 0) out vec4 cloud;           // light by unit solar irradiance [1/sr], transmittance
layout(location = 1) out float cloud_distance;  // [m]

const int samples = 40;
const int sun_looks = 5;
const int orders = 4;
const float droplets = 20.0;  // [um] diameter

// What lights the clouds around a place.
struct CloudLight {
    vec3 sunlight;  // past the air
    vec3 above;     // [1/sr] mean radiance of the sky above
    vec3 below;     // [1/sr] of the ground and air below
};

CloudLight light_around(vec3 position, Light light) {
    airlight_Viewpoint here =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, position, vec3(0.0, 0.0, 1.0));
    float mu_s = clamp(airlight_dot_product(here.up, light.direction), -1.0, 1.0);
    vec3 sunlight = airlight_transmittance_to_space(atmosphere, here.altitude, mu_s);
#if TABLES == TABLES_DIFFUSE
    airlight_SkyIrradiance sky = light_on_surfaces(here.altitude, mu_s);
    return CloudLight(sunlight, sky.down / airlight_pi, sky.up / airlight_pi);
#else
    vec3 above = air_light(atmosphere, frame, here, here.up, light.direction, airlight_no_surface(),
                           frame.sky_steps)
                     .radiance;
    return CloudLight(sunlight, above, atmosphere.ground_albedo * sunlight * (max(mu_s, 0.0) / airlight_pi));
#endif
}

// Light scattered towards the eye by a unit of optical depth. Further orders of scattering are the first again,
// each half as much, by half the depth and with a rounder phase function (Wrenninge, Kulla and Lundqvist 2013).
vec3 scattered_by_cloud(CloudLight around, vec3 position, vec3 direction, Light light, float footprint,
                        float density) {
    airlight_Viewpoint here =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, position, vec3(0.0, 0.0, 1.0));
    float mu_s = dot(here.up, light.direction);
    float rise = mu_s >= 0.0 ? cloud_top - here.altitude : here.altitude - cloud_base;
    float way = min(rise / max(abs(mu_s), 0.05), 4000.0);
    float depth =
        cloud_depth(atmosphere.ground_radius, position, light.direction, vec2(0.0, way), sun_looks, footprint);
    float cos_theta = dot(direction, light.direction);
    float sun = airlight_fog_phase(cos_theta, droplets) * exp(-depth);
    float weight = 1.0;
    float g = 0.8;
    for (int i = 1; i < orders; ++i) {
        weight *= 0.5;
        g *= 0.5;
        sun += weight * airlight_cornette_shanks_phase(cos_theta, g) * exp(-weight * depth);
    }
    // Even light from both sides, as dense as it is here.
    float up = cloud_light_through(density * max(cloud_top - here.altitude, 0.0));
    float down = cloud_light_through(density * max(here.altitude - cloud_base, 0.0));
    return light.irradiance *
           (sun * around.sunlight + 0.5 * (up * around.above + down * around.below));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ViewRay ray = view_ray(pixel, texelFetch(depth_texture, pixel, 0).x);
    vec3 direction = ray.direction;
    airlight_Viewpoint eye = camera_viewpoint();
    CloudStretches stretches = cloud_stretches(atmosphere.ground_radius, eye, direction, ray.distance);
    float pixel_width = length(frame.ray_up) / length(pixel_ray(frame, pixel));

    vec3 sum = vec3(0.0);
    float through = 1.0;
    float way = 0.0;
    for (int k = 0; k < 2; ++k) {
        vec2 stretch = k == 0 ? stretches.first : stretches.second;
        if (stretch.x >= stretch.y || through < 1e-6) {
            continue;
        }
        // The steps grow with the distance from the eye.
        const float finest = 600.0;
        float growth = log((stretch.y + finest) / (stretch.x + finest));
        float t = stretch.x;
        // Its lights at both ends; between them they change little.
        CloudLight near_light[2];
        CloudLight far_light[2];
        for (int l = 0; l < frame.lights; ++l) {
            near_light[l] = light_around(frame.eye_position + direction * stretch.x, light_of(frame, l));
            far_light[l] = light_around(frame.eye_position + direction * stretch.y, light_of(frame, l));
        }
        for (int i = 0; i < samples && through > 1e-6; ++i) {
            float s = (float(i) + 1.0) / float(samples);
            float end = (stretch.x + finest) * exp(growth * s) - finest;
            float width = end - t;
            float middle = 0.5 * (t + end);
            t = end;
            vec3 position = frame.eye_position + direction * middle;
            float footprint = max(pixel_width * middle, 0.5 * width);
            float density = cloud_density(atmosphere.ground_radius, position, footprint);
            if (density <= 0.0) {
                continue;
            }
            float share = through * (1.0 - exp(-density * width));
            float along = clamp((middle - stretch.x) / (stretch.y - stretch.x), 0.0, 1.0);
            for (int l = 0; l < frame.lights; ++l) {
                CloudLight around =
                    CloudLight(mix(near_light[l].sunlight, far_light[l].sunlight, along),
                               mix(near_light[l].above, far_light[l].above, along),
                               mix(near_light[l].below, far_light[l].below, along));
                sum += share * scattered_by_cloud(around, position, direction, light_of(frame, l), footprint,
                                                  density);
            }
            way += share * middle;
            through -= share;
        }
    }
    cloud = vec4(sum, through);
    cloud_distance = through < 1.0 ? way / (1.0 - through) : 0.0;
}
