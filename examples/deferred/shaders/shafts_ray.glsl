// The light that shadows keep from the air in front of a pixel: looks at the shadow maps along its ray.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "shadows.glsl"

#define AIRLIGHT_VISIBILITY(position) sun_reaches(position)
#include "airlight/light_shafts.glsl"
#include "airlight/viewpoint.glsl"

uniform sampler2D depth_texture;
uniform int scale;  // pixels each way that share a ray
uniform int pieces;
uniform int looks;

struct ShaftPixel {
    vec3 direction;
    float distance;
};

ShaftPixel shaft_pixel(ivec2 pixel) {
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = length(ray);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    return ShaftPixel(ray / ray_length,
                      depth > 0.0 ? frame.near_distance / depth * ray_length : airlight_no_surface());
}

vec3 lost_before(ShaftPixel pixel, float offset) {
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    airlight_Viewpoint eye =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
    return airlight_light_lost_in_shadow(atmosphere, eye, pixel.direction, to_mapped_light(frame),
                                         pixel.distance, shadow_range, pieces, looks, offset);
}

// About how much light there is to lose: what neighbours lose of it is more alike than what they lose.
vec3 light_to_lose(ShaftPixel pixel) {
    float cosine = dot(pixel.direction, to_mapped_light(frame));
    float way = min(pixel.distance, shadow_range);
    return (atmosphere.rayleigh_scattering * airlight_rayleigh_phase(cosine) +
            atmosphere.mie_scattering * airlight_mie_phase(cosine, atmosphere.mie_g)) *
           (way / (1.0 + way / 40e3));
}
