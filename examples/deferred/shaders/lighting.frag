// The one pass of light and air, over the whole screen.
#include "shading.glsl"

uniform Frame frame;
uniform sampler2D depth_texture;
uniform sampler2D albedo_texture;  // and roughness
uniform sampler2D normal_texture;

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(albedo_texture, pixel, 0);
    Surface surface = Surface(texelFetch(depth_texture, pixel, 0).x, albedo.xyz, albedo.w,
                              texelFetch(normal_texture, pixel, 0).xyz);
    radiance = vec4(pixel_radiance(atmosphere, frame, surface, pixel), 1.0);
}
