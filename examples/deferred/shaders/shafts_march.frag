// Light shafts, one ray for each pixel, or for each 2 x 2 of them.
#include "interleaved.glsl"
#include "shafts_ray.glsl"

layout(location = 0) out vec4 lost;  // of light_to_lose, and the distance of the surface

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(texel * scale, ivec2(frame.width - 1, frame.height - 1));
    ViewRay ray = view_ray(pixel, texelFetch(depth_texture, pixel, 0).x);
    lost = vec4(lost_before(ray, interleaved(texel)) / max(light_to_lose(ray), 1e-30), ray.distance);
}
