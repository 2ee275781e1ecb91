// The landscape's triangles, in positions relative to the camera.
#include "frame.glsl"

layout(location = 0) in vec3 vertex_position;  // [m] from the camera
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in float vertex_height;  // [m] above the ground sphere

out vec3 position;
out vec3 normal;
out float height;

void main() {
    position = vertex_position;
    normal = vertex_normal;
    height = vertex_height;

    // Along the view axis: all rays have length 1 there, so it is what the edges leave.
    vec3 across = normalize(frame.ray_across);
    vec3 up = normalize(frame.ray_up);
    vec3 forward = cross(up, across);
    float pixel = length(frame.ray_up);
    float depth = dot(forward, vertex_position);
    vec2 half_size = 0.5 * pixel * vec2(float(frame.width), float(frame.height));
    vec2 screen = vec2(dot(across, vertex_position), dot(up, vertex_position)) / half_size;

    // Reversed, without a far end: stored depth = near / depth, 0 at infinity.
#if CLIP_CONTROL
    gl_Position = vec4(screen, frame.near_distance, depth);
#else
    gl_Position = vec4(screen, 2.0 * frame.near_distance - depth, depth);
#endif
}
