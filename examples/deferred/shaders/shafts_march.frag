// The light that shadows keep from the air in front of each pixel: looks at the shadow maps along its ray.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "interleaved.glsl"
#include "shadows.glsl"

#define AIRLIGHT_VISIBILITY(position) sun_reaches(position)
#include "airlight/light_shafts.glsl"
#include "airlight/viewpoint.glsl"

uniform sampler2D depth_texture;
uniform int scale;   // pixels each way that share a ray
uniform int pieces;
uniform int looks;

layout(location = 0) out vec4 lost;  // and the distance of the surface

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(texel * scale, ivec2(frame.width - 1, frame.height - 1));
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = length(ray);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    float distance = depth > 0.0 ? frame.near_distance / depth * ray_length : airlight_no_surface();
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    airlight_Viewpoint eye =
        airlight_viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
    lost = vec4(airlight_light_lost_in_shadow(atmosphere, eye, ray / ray_length, to_mapped_light(frame), distance,
                                              shadow_range, pieces, looks, interleaved(texel)),
                distance);
}
