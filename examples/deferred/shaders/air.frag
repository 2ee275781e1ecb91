// The air between the eye and each pixel's surface.
#include "shading.glsl"

uniform sampler2D depth_texture;
uniform sampler2D behind_texture;  // what there would be to see without air
uniform sampler2D lost_texture;    // light that shadows keep from the air
uniform bool any_lost;

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 lost = any_lost ? texelFetch(lost_texture, pixel, 0).xyz : vec3(0.0);
    radiance = vec4(light_through_air(atmosphere, frame, texelFetch(depth_texture, pixel, 0).x,
                                      texelFetch(behind_texture, pixel, 0).xyz, lost, pixel),
                    1.0);
}
