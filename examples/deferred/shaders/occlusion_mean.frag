// The mean of the 4 x 4 pixels around each, which have looked along different lines: of those near the plane of
// its surface, so that nothing leaks across an edge.
#include "occlusion.glsl"

uniform sampler2D depth_texture;
uniform sampler2D normal_texture;
uniform sampler2D share_texture;

layout(location = 0) out float share;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    share = 1.0;
    if (depth <= 0.0) {
        return;
    }
    vec3 position = position_of(pixel, depth);
    vec3 normal = normalize(texelFetch(normal_texture, pixel, 0).xyz);
    float radius = radius_at(depth, reach_at(depth, length(position)));
    ivec2 size = textureSize(depth_texture, 0);
    // The pixel itself counts even where rounding puts it off its plane.
    vec2 sum = 1e-6 * vec2(texelFetch(share_texture, pixel, 0).x, 1.0);
    for (int y = -1; y < 3; ++y) {
        for (int x = -1; x < 3; ++x) {
            ivec2 place = clamp(pixel + ivec2(x, y), ivec2(0), size - 1);
            float other = texelFetch(depth_texture, place, 0).x;
            if (other > 0.0) {
                float apart = dot(position_of(place, other) - position, normal) / (0.1 * radius);
                sum += exp2(-apart * apart) * vec2(texelFetch(share_texture, place, 0).x, 1.0);
            }
        }
    }
    share = sum.x / sum.y;
}
