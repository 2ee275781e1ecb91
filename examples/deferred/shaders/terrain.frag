// The landscape's triangles into the G-buffer.
#include "frame.glsl"
#include "ground.glsl"

in vec3 position;  // [m] from the camera
in vec3 normal;
in float height;

uniform float ground_radius;
uniform vec3 bare_albedo;
uniform bool vegetated;

layout(location = 0) out vec4 out_albedo;  // and roughness
layout(location = 1) out vec4 out_normal;

void main() {
    vec3 from_centre = frame.eye_position + position;
    vec3 up = normalize(from_centre + vec3(0.0, 0.0, ground_radius));
    vec3 n = normalize(normal);
    float slant = max(abs(dot(n, normalize(position))), 0.05);
    float footprint = length(position) * length(frame.ray_up) / slant;
    Ground ground =
        ground_at(from_centre, up, height, dot(n, up), footprint, ground_radius, bare_albedo, vegetated);
    out_albedo = vec4(ground.albedo, ground.roughness);
    out_normal = vec4(n, 0.0);
    // What the hardware would store too, but it may lose digits on the way through [-1, 1].
    gl_FragDepth = frame.near_distance * gl_FragCoord.w;
}
