// Where the G-buffer's surfaces are, and how far around them others hide their sky.
#include "frame.glsl"

// Relative to the eye [m]; depth is above 0.
vec3 position_of(ivec2 pixel, float depth) {
    return pixel_ray(frame, pixel) * (frame.near_distance / depth);
}

// How many pixels wide the surroundings are that may hide some of a surface's sky: a share of its distance, so
// that hills have theirs as stones do; at least half a metre; at most an eighth of the picture.
float reach_at(float depth, float distance) {
    float radius = max(0.1 * distance, 0.5);
    float pixel = length(frame.ray_up) * frame.near_distance / depth;
    return min(radius / pixel, 0.125 * float(frame.height));
}

// The same in metres.
float radius_at(float depth, float reach) {
    return reach * length(frame.ray_up) * frame.near_distance / depth;
}
