// The light that shadows keep from the air along the rays of all slices.
#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "cascades.glsl"
#include "epipolar_lost.glsl"

uniform sampler2D depth_texture;

layout(location = 0) out vec4 lost;  // and the distance of the surface, negative where no pixel sees it

void main() {
    int slice = int(gl_FragCoord.y);
    float angle = sample_angle(gl_FragCoord.x - 0.5);
    vec3 direction = cos(angle) * to_mapped_light(frame) + sin(angle) * slice_direction(float(slice));

    // The pixel that looks there.
    vec3 forward = normalize(cross(frame.ray_up, frame.ray_across));
    float facing = dot(direction, forward);
    vec3 ray = direction / max(facing, 1e-6) - frame.ray_corner;
    vec2 pixel = vec2(dot(ray, frame.ray_across) / dot(frame.ray_across, frame.ray_across),
                      dot(ray, frame.ray_up) / dot(frame.ray_up, frame.ray_up));
    vec2 size = vec2(frame.width, frame.height);
    if (facing < 1e-3 || any(lessThan(pixel, vec2(-1.0))) || any(greaterThan(pixel, size + 1.0))) {
        lost = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    float depth = texelFetch(depth_texture, ivec2(clamp(pixel, vec2(0.0), size - 1.0)), 0).x;
    ViewRay seen =
        ViewRay(direction, depth > 0.0 ? frame.near_distance / depth / facing : airlight_no_surface());
    lost = vec4(light_lost_in_slice(seen, slice), seen.distance);
}
