// Light that leaves each pixel's surface towards the eye.
#include "shading.glsl"

uniform sampler2D depth_texture;
uniform sampler2D albedo_texture;  // and roughness
uniform sampler2D normal_texture;
uniform sampler2D shares_texture;  // of the sun and of the sky

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(albedo_texture, pixel, 0);
    vec2 shares = texelFetch(shares_texture, pixel, 0).xy;
    Surface surface = Surface(texelFetch(depth_texture, pixel, 0).x, albedo.xyz, albedo.w,
                              texelFetch(normal_texture, pixel, 0).xyz, shares.x, shares.y);
    radiance = vec4(light_behind_air(atmosphere, frame, surface, pixel), 1.0);
}
