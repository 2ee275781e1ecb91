// The air between the eye and each pixel's surface.
#include "shading.glsl"

uniform sampler2D depth_texture;
uniform sampler2D behind_texture;  // what there would be to see without air
uniform sampler2D lost_texture;    // light that shadows keep from the air
uniform bool any_lost;
#ifdef CLOUDS
uniform sampler2D cloud_texture;  // light, transmittance
uniform sampler2D cloud_distance_texture;
#endif

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 lost = any_lost ? texelFetch(lost_texture, pixel, 0).xyz : vec3(0.0);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    vec3 behind = texelFetch(behind_texture, pixel, 0).xyz;
#ifdef CLOUDS
    vec4 light = texelFetch(cloud_texture, pixel, 0);
    Cloud cloud = Cloud(light.xyz, light.w, texelFetch(cloud_distance_texture, pixel, 0).x);
    radiance = vec4(light_through_clouds(atmosphere, frame, depth, behind, lost, cloud, pixel), 1.0);
#else
    radiance = vec4(light_through_air(atmosphere, frame, depth, behind, lost, pixel), 1.0);
#endif
}
