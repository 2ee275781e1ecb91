// Triangles as the sun sees them, into one cascade.
#include "cascades.glsl"

layout(location = 0) in vec3 vertex_position;  // [m] from the camera

uniform int cascade;

void main() {
    vec3 place = in_cascade(cascade, vertex_position);
#if CLIP_CONTROL
    gl_Position = vec4(2.0 * place.xy - 1.0, place.z, 1.0);
#else
    gl_Position = vec4(2.0 * place - 1.0, 1.0);
#endif
}
