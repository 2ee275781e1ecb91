// How much of the sun and of the sky each surface sees, and which cascade told.
#include "frame.glsl"
#include "shadows.glsl"

#ifdef CLOUDS
#include "atmosphere_block.glsl"
#include "clouds.glsl"
#endif

uniform sampler2D depth_texture;
uniform sampler2D normal_texture;
uniform sampler2D sky_share_texture;
uniform bool any_occlusion;

layout(location = 0) out vec4 shares;  // of the sun, of the sky, the cascade's number, unused

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    shares = vec4(1.0, 1.0, 4.0, 0.0);
    if (any_occlusion) {
        shares.y = texelFetch(sky_share_texture, pixel, 0).x;
    }
    if (shadows_on && depth > 0.0) {
        vec3 position = pixel_ray(frame, pixel) * (frame.near_distance / depth);
        vec3 normal = normalize(texelFetch(normal_texture, pixel, 0).xyz);
        shares.x = sun_reaches_surface(position, normal, to_mapped_light(frame));
        shares.z = float(cascade_at(position, 0.01));
    }
#ifdef CLOUDS
    if (depth > 0.0) {
        vec3 ray = pixel_ray(frame, pixel) * (frame.near_distance / depth);
        vec3 place = frame.eye_position + ray;
        airlight_Viewpoint here =
            airlight_viewpoint_from_surface(atmosphere.ground_radius, place, vec3(0.0, 0.0, 1.0));
        CloudStretches above = cloud_stretches(atmosphere.ground_radius, here, to_mapped_light(frame), 1e6);
        float footprint = length(ray) * length(frame.ray_up);
        float cover =
            cloud_depth(atmosphere.ground_radius, place, to_mapped_light(frame), above.first, 6, footprint) +
            cloud_depth(atmosphere.ground_radius, place, to_mapped_light(frame), above.second, 6, footprint);
        shares.x *= cloud_light_through(cover);
    }
#endif
}
