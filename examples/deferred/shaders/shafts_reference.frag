// The light that shadows keep from the air, by brute force: even steps with the shadow maps, and without.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "shadows.glsl"
#include "view_ray.glsl"

bool shaded = true;
#define AIRLIGHT_VISIBILITY(position) (shaded ? sun_reaches(position) : 1.0)
#include "airlight/single_scattering.glsl"

uniform sampler2D depth_texture;
uniform int steps;

layout(location = 0) out vec4 lost;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ViewRay ray = view_ray(pixel, texelFetch(depth_texture, pixel, 0).x);
    float distance = min(ray.distance, shadow_range);
    airlight_Viewpoint eye = camera_viewpoint();
    vec3 seen =
        airlight_single_scattering_marched(atmosphere, eye, ray.direction, to_mapped_light(frame), distance, steps).radiance;
    shaded = false;
    vec3 lit =
        airlight_single_scattering_marched(atmosphere, eye, ray.direction, to_mapped_light(frame), distance, steps).radiance;
    lost = vec4(max(lit - seen, 0.0), 1.0);
}
