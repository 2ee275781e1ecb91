// A level of half the size: the 13 looks of Jimenez, Next Generation Post Processing in Call of Duty: Advanced
// Warfare (2014), which are five boxes of 4 x 4 texels, written out as 6 x 6 weights. All texels weigh the same in
// the whole, so that a small light is as bright wherever it lies between them, and does not flicker as it moves.
#include "bloom.glsl"

uniform sampler2D finer_texture;

layout(location = 0) out vec4 coarser;

void main() {
    const float middle_box[6] = float[6](0.0, 1.0, 1.0, 1.0, 1.0, 0.0);
    const float corner_boxes[6] = float[6](1.0, 1.0, 2.0, 2.0, 1.0, 1.0);
    ivec2 size = textureSize(finer_texture, 0);
    ivec2 first = 2 * ivec2(gl_FragCoord.xy) - 2;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) {
            float weight = middle_box[x] * middle_box[y] / 32.0 + corner_boxes[x] * corner_boxes[y] / 128.0;
            vec3 radiance = texelFetch(finer_texture, mirrored(first + ivec2(x, y), size), 0).xyz;
            sum += weight * bounded(radiance);
        }
    }
    coarser = vec4(sum, 1.0);
}
