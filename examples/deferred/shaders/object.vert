// The objects' triangles, in positions relative to the camera.
#include "projection.glsl"

layout(location = 0) in vec3 vertex_position;  // [m] from the camera
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec4 vertex_paint;  // albedo, roughness

out vec3 normal;
out vec4 paint;

void main() {
    normal = vertex_normal;
    paint = vertex_paint;
    gl_Position = projected(vertex_position);
}
