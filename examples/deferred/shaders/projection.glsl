// From places relative to the camera to places on the screen.
#include "frame.glsl"

vec4 projected(vec3 position) {
    // Along the view axis: all rays have length 1 there, so it is what the edges leave.
    vec3 across = normalize(frame.ray_across);
    vec3 up = normalize(frame.ray_up);
    vec3 forward = cross(up, across);
    float pixel = length(frame.ray_up);
    float depth = dot(forward, position);
    vec2 half_size = 0.5 * pixel * vec2(float(frame.width), float(frame.height));
    vec2 screen = vec2(dot(across, position), dot(up, position)) / half_size;

    // Reversed, without a far end: stored depth = near / depth, 0 at infinity.
#if CLIP_CONTROL
    return vec4(screen, frame.near_distance, depth);
#else
    return vec4(screen, 2.0 * frame.near_distance - depth, depth);
#endif
}
