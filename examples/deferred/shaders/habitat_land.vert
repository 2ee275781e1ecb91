// The habitat's land: triangles in positions from the cylinder's middle.
#include "projection.glsl"

layout(location = 0) in vec3 vertex_position;  // [m] from the middle
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in float vertex_height;  // [m] above the wall

out vec3 position;
out vec3 normal;
out float height;

void main() {
    position = vertex_position;
    normal = vertex_normal;
    height = vertex_height;
    gl_Position = projected(vertex_position - frame.eye_position);
}
