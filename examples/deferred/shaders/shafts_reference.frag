// The light that shadows keep from the air, by brute force: even steps with the shadow maps, and without.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "shadows.glsl"

bool shaded = true;
#define AIRLIGHT_VISIBILITY(position) (shaded ? sun_reaches(position) : 1.0)
#include "airlight/single_scattering.glsl"
#include "airlight/viewpoint.glsl"

uniform sampler2D depth_texture;
uniform int steps;

layout(location = 0) out vec4 lost;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = length(ray);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    float distance =
        min(depth > 0.0 ? frame.near_distance / depth * ray_length : airlight_no_surface(), shadow_range);
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    airlight_Viewpoint eye =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
    vec3 direction = ray / ray_length;
    vec3 seen =
        airlight_single_scattering_marched(atmosphere, eye, direction, to_mapped_light(frame), distance, steps).radiance;
    shaded = false;
    vec3 lit =
        airlight_single_scattering_marched(atmosphere, eye, direction, to_mapped_light(frame), distance, steps).radiance;
    lost = vec4(max(lit - seen, 0.0), 1.0);
}
