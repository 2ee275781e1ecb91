// The light that shadows keep from the air in front of a pixel: looks at the shadow maps along its ray.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "shadows.glsl"
#include "view_ray.glsl"

#define AIRLIGHT_VISIBILITY(position) sun_reaches(position)
#include "airlight/light_shafts.glsl"

uniform sampler2D depth_texture;
uniform int scale;  // pixels each way that share a ray
uniform int pieces;
uniform int looks;

vec3 lost_before(ViewRay ray, float offset) {
    return airlight_light_lost_in_shadow(atmosphere, camera_viewpoint(), ray.direction, to_mapped_light(frame),
                                         ray.distance, shadow_range, pieces, looks, offset);
}

// About how much light there is to lose: what neighbours lose of it is more alike than what they lose.
vec3 light_to_lose(ViewRay ray) {
    float cosine = dot(ray.direction, to_mapped_light(frame));
    float way = min(ray.distance, shadow_range);
    return (atmosphere.rayleigh_scattering * airlight_rayleigh_phase(cosine) +
            atmosphere.mie_scattering * airlight_mie_phase(cosine, atmosphere.mie_g)) *
           (way / (1.0 + way / 40e3));
}
