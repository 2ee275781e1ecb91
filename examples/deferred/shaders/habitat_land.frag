// The habitat's land into the G-buffer, with the share of each pixel that a strip of light fills.
#include "airlight/habitat_mapping.glsl"

#include "frame.glsl"
#include "noise.glsl"

in vec3 position;  // [m] from the cylinder's middle
in vec3 normal;
in float height;  // [m] above the wall

uniform airlight_HabitatAir air;
uniform airlight_HabitatLights lights;
uniform bool plain;  // land of one colour
uniform vec3 wall_albedo;

layout(location = 0) out vec4 out_albedo;  // and the strip's share
layout(location = 1) out vec4 out_normal;

// The share of a pixel that covers what is within `reach` of a middle `away` from it, itself `size` wide. At
// grazing angles a pixel's size is a guess: a strip is never smeared over more than four times its reach.
float covered(float away, float reach, float size) {
    size = clamp(size, 1e-3 * reach, 4.0 * reach);
    return (clamp(away + 0.5 * size, -reach, reach) - clamp(away - 0.5 * size, -reach, reach)) / size;
}

// Every place has noise of its own, though the height map goes there and back again.
vec3 rock(vec3 position, float footprint) {
    return vec3(0.16, 0.155, 0.15) * (1.0 + 0.6 * octaves(position, 3000.0, 10, footprint));
}

vec3 land(vec3 position, float height, float flatness, float footprint) {
    vec3 forest = vec3(0.045, 0.065, 0.028);
    vec3 meadow = vec3(0.150, 0.160, 0.070);
    vec3 soil = vec3(0.300, 0.245, 0.175);
    float fine = octaves(position, 700.0, 10, footprint);
    float coarse = octaves(position + 3e4, 5000.0, 6, footprint);
    float open = smoothstep(-0.2, 0.2, 0.6 * fine + coarse);
    float bare = smoothstep(0.06, 0.2, 1.0 - flatness + 0.05 * fine) + 0.5 * smoothstep(0.2, 0.7, fine + coarse);
    vec3 albedo = mix(mix(forest, meadow, open), soil, clamp(bare, 0.0, 1.0));
    // What is level is paved: the stretches along the strips of light.
    return mix(vec3(0.26, 0.25, 0.235), albedo * (1.0 + 0.7 * fine), smoothstep(0.0, 4.0, height));
}

void main() {
    vec3 from_eye = position - frame.eye_position;
    vec3 n = normalize(normal);
    float slant = max(abs(dot(n, normalize(from_eye))), 0.05);
    float footprint = length(from_eye) * length(frame.ray_up) / slant;
    bool on_cap = lights.half_length - abs(position.x) < 0.5;
    vec3 up = on_cap ? n : normalize(vec3(0.0, -position.yz));
    vec3 albedo = on_cap ? rock(position, footprint) : land(position, height, dot(n, up), footprint);

    float share = 0.0;
    for (int i = 0; i < 6; ++i) {
        airlight_LinearLight strip = airlight_habitat_strip(air, lights, i);
        vec3 d = position - strip.centre;
        float across = dot(cross(strip.along, strip.normal), d);
        float along = dot(strip.along, d);
        float here = covered(across, 0.5 * strip.width, fwidth(across)) *
                     covered(along, strip.half_length, min(fwidth(along), strip.width));
        share = max(share, dot(strip.normal, d) < 0.5 * air.radius ? here : 0.0);
    }
    out_albedo = vec4(plain ? wall_albedo : albedo, share);
    out_normal = vec4(n, 0.0);
    // What the hardware would store too, but it may lose digits on the way through [-1, 1].
    gl_FragDepth = frame.near_distance * gl_FragCoord.w;
}
