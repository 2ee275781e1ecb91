// Brings marched light to every pixel: the mean of the 4 x 4 rays around it that end as far away as its own.
#include "frame.glsl"

uniform sampler2D depth_texture;
uniform sampler2D marched_texture;  // light, and how far its ray went
uniform int scale;

layout(location = 0) out vec4 lost;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    float distance = depth > 0.0 ? frame.near_distance / depth * length(pixel_ray(frame, pixel)) : 1e30;
    ivec2 size = textureSize(marched_texture, 0);
    ivec2 first = pixel / scale - (scale == 1 ? ivec2(1) : 2 - (pixel & 1));
    vec4 sum = vec4(0.0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            vec4 texel = texelFetch(marched_texture, clamp(first + ivec2(x, y), ivec2(0), size - 1), 0);
            float apart = abs(texel.w - distance) / max(texel.w, distance);
            float weight = max(exp2(-2000.0 * apart * apart), 1e-6);
            sum += weight * vec4(texel.xyz, 1.0);
        }
    }
    lost = vec4(sum.xyz / sum.w, 1.0);
}
