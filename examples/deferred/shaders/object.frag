// The objects' triangles into the G-buffer.
#include "frame.glsl"

in vec3 normal;
in vec4 paint;

layout(location = 0) out vec4 out_albedo;  // and roughness
layout(location = 1) out vec4 out_normal;

void main() {
    out_albedo = paint;
    out_normal = vec4(normalize(normal), 0.0);
    gl_FragDepth = frame.near_distance * gl_FragCoord.w;
}
