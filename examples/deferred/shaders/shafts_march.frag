// Light shafts, one ray for each pixel, or for each 2 x 2 of them.
#include "interleaved.glsl"
#include "shafts_ray.glsl"

layout(location = 0) out vec4 lost;  // of light_to_lose, and the distance of the surface

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ShaftPixel pixel = shaft_pixel(min(texel * scale, ivec2(frame.width - 1, frame.height - 1)));
    lost = vec4(lost_before(pixel, interleaved(texel)) / max(light_to_lose(pixel), 1e-30), pixel.distance);
}
