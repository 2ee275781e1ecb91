// Brings marched light to every pixel: the mean of the 4 x 4 rays around it that end as far away as its own. A pixel
// at a break of depth that has none gets a ray of its own.
#include "shafts_ray.glsl"

uniform sampler2D marched_texture;  // share of the light, and how far its ray went

layout(location = 0) out vec4 lost;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ViewRay ray = view_ray(texel, texelFetch(depth_texture, texel, 0).x);
    ivec2 size = textureSize(marched_texture, 0);
    ivec2 first = texel / scale - (scale == 1 ? ivec2(1) : 2 - (texel & 1));
    vec4 sum = vec4(0.0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            vec4 marched = texelFetch(marched_texture, clamp(first + ivec2(x, y), ivec2(0), size - 1), 0);
            float apart = abs(marched.w - ray.distance) / max(marched.w, ray.distance);
            sum += exp2(-500.0 * apart * apart) * vec4(marched.xyz, 1.0);
        }
    }
    lost = vec4(sum.w > 0.5 ? light_to_lose(ray) * sum.xyz / sum.w : lost_before(ray, 0.5), 1.0);
}
