// The shadow maps as heights.
#include "cascades.glsl"

uniform sampler2DArray shadow_heights;

// How high along the sunlight, from the eye [m], the air over a place relative to the eye is shaded; -1e30 where
// nothing is in the way. Of the place only what is across the sunlight counts.
float shaded_height(vec3 position) {
    for (int i = 0; i < 4; ++i) {
        vec2 place = in_cascade(i, position).xy;
        if (all(lessThan(abs(place - 0.5), vec2(0.498)))) {
            ivec3 size = textureSize(shadow_heights, 0);
            float depth = texelFetch(shadow_heights, ivec3(ivec2(place * vec2(size.xy)), i), 0).x;
            vec4 row = cascades[i].depth;
            return depth < 1.0 ? (row.w - depth) / length(row.xyz) : -1e30;
        }
    }
    return -1e30;
}
