// Stars, infinitely far away.
#include "projection.glsl"

layout(location = 0) in vec3 direction;
layout(location = 1) in vec3 light;

flat out vec3 star_light;
flat out vec2 middle;  // in pixels

void main() {
    star_light = light;
    vec4 place = projected(direction);
    middle = (0.5 + 0.5 * place.xy / place.w) * vec2(float(frame.width), float(frame.height));
#if CLIP_CONTROL
    gl_Position = vec4(place.xy, 0.0, place.w);
#else
    gl_Position = vec4(place.xy, -place.w, place.w);
#endif
    gl_PointSize = 2.0;
}
