// A level with the share of all coarser ones.
#include "bloom.glsl"

uniform sampler2D level_texture;
uniform sampler2D coarser_texture;
uniform float coarser_share;

layout(location = 0) out vec4 glow;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 level = texelFetch(level_texture, pixel, 0).xyz;
    glow = vec4(mix(level, brought_up(coarser_texture, pixel), coarser_share), 1.0);
}
