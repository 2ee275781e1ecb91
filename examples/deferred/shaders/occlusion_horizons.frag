// The share of its sky that each surface sees, between the horizons that its neighbours on the screen make: after
// Jimenez et al., Practical Realtime Strategies for Accurate Indirect Occlusion (2016), equations 5 to 10.
#include "airlight/constants.glsl"
#include "interleaved.glsl"
#include "occlusion.glsl"

uniform sampler2D depth_texture;
uniform sampler2D normal_texture;

layout(location = 0) out float share;

const int lines = 2;  // across the screen through each pixel
const int looks = 5;  // along each, both ways

// Sine of the horizon above the surface's own plane, one way along a line. Above the plane and not against the
// line of sight: a look falls between pixels, and on level ground far away the next row is many metres nearer.
float horizon(vec3 position, vec3 normal, ivec2 pixel, vec2 along, float reach, float radius, float noise) {
    ivec2 size = textureSize(depth_texture, 0);
    float highest = 0.0;
    for (int i = 0; i < looks; ++i) {
        float part = (float(i) + noise) / float(looks);
        ivec2 place = ivec2(floor(vec2(pixel) + 0.5 + along * (1.0 + (reach - 1.0) * part * part)));
        if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, size))) {
            break;
        }
        float depth = texelFetch(depth_texture, place, 0).x;
        if (depth > 0.0) {
            vec3 to_place = position_of(place, depth) - position;
            float squared = dot(to_place, to_place);
            // What is far behind or in front of the surface hides nothing.
            float weight = max(1.0 - squared / (radius * radius), 0.0);
            highest = max(highest, weight * dot(to_place, normal) * inversesqrt(max(squared, 1e-30)));
        }
    }
    return highest;
}

// Integral of the light from an even sky between the line of sight and a horizon at angle h of it, in a plane in
// which the normal is at angle n.
float inner_arc(float h, float n) {
    return 0.25 * (cos(n) - cos(2.0 * h - n) + 2.0 * h * sin(n));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    share = 1.0;
    if (depth <= 0.0) {
        return;
    }
    vec3 position = position_of(pixel, depth);
    float distance = length(position);
    vec3 to_eye = -position / distance;
    vec3 normal = normalize(texelFetch(normal_texture, pixel, 0).xyz);
    float reach = reach_at(depth, distance);
    float radius = radius_at(depth, reach);
    if (reach <= 1.0) {
        return;
    }

    float seen = 0.0;
    float open = 0.0;
    for (int i = 0; i < lines; ++i) {
        float angle = airlight_pi * (float(i) + interleaved(pixel)) / float(lines);
        vec2 along = vec2(cos(angle), sin(angle));
        // The plane through the line and the eye, in which angles count from the line of sight.
        vec3 tangent = along.x * frame.ray_across + along.y * frame.ray_up;
        tangent = normalize(tangent - to_eye * dot(tangent, to_eye));
        vec3 in_plane = normal - cross(tangent, to_eye) * dot(normal, cross(tangent, to_eye));
        float weight = length(in_plane);
        float n = atan(dot(in_plane, tangent), max(dot(in_plane, to_eye), 0.0));

        float noise = interleaved(pixel.yx + 2);
        float least = max(weight, 1e-6);
        float ahead = asin(min(horizon(position, normal, pixel, along, reach, radius, noise) / least, 1.0));
        float behind = asin(min(horizon(position, normal, pixel, -along, reach, radius, noise) / least, 1.0));
        float quarter = 0.5 * airlight_pi;
        // No horizon is past the line of sight, along which the surface is seen.
        seen += weight * (inner_arc(max(n + quarter - ahead, 0.0), n) + inner_arc(min(n - quarter + behind, 0.0), n));
        open += weight * (inner_arc(n + quarter, n) + inner_arc(n - quarter, n));
    }
    // By what these lines would see of an open sky, so that few of them suffice where nothing hides any; fading
    // where the surroundings are hardly wider than a pixel.
    float hidden = 1.0 - seen / max(open, 1e-6);
    share = 1.0 - hidden * min(reach - 1.0, 1.0);
}
