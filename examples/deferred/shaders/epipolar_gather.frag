// Brings the slices' light to every pixel: from the four rays around it that end as far away as its own. A pixel
// at a break of depth that has none gets a ray of its own.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "cascades.glsl"
#include "epipolar_lost.glsl"

uniform sampler2D depth_texture;
uniform sampler2D marched_texture;

layout(location = 0) out vec4 lost;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ViewRay ray = view_ray(pixel, texelFetch(depth_texture, pixel, 0).x);

    vec2 place = epipolar_place(ray.direction, to_mapped_light(frame));
    ivec2 first = ivec2(floor(place));
    vec2 share = place - vec2(first);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 at = first + corner;
        at.x = clamp(at.x, 0, samples - 1);
        at.y = whole_circle ? (at.y + slices) % slices : clamp(at.y, 0, slices - 1);
        vec4 texel = texelFetch(marched_texture, at, 0);
        float apart = abs(texel.w - ray.distance) / max(texel.w, ray.distance);
        vec2 w = mix(1.0 - share, share, vec2(corner));
        float weight = texel.w > 0.0 && apart < 0.1 ? (w.x * w.y + 1e-3) * exp2(-1000.0 * apart * apart) : 0.0;
        sum += weight * vec4(texel.xyz, 1.0);
    }
    if (sum.w > 1e-4) {
        lost = vec4(sum.xyz / sum.w, 1.0);
        return;
    }
    int slice = clamp(int(floor(place.y + 0.5)), 0, slices);
    lost = vec4(light_lost_in_slice(ray, slice % slices), 0.0);
}
