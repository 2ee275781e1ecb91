// Light of each pixel's surface through the habitat's air, and of the air.
#include "frame.glsl"
#include "habitat_shading.glsl"

uniform sampler2D depth_texture;
uniform sampler2D albedo_texture;  // and the strip's share
uniform sampler2D normal_texture;

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depth_texture, pixel, 0).x;
    vec4 albedo = texelFetch(albedo_texture, pixel, 0);
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = length(ray);
    vec3 direction = ray / ray_length;
    float distance = depth > 0.0 ? frame.near_distance / depth * ray_length : 0.0;
    vec3 position = frame.eye_position + distance * direction;
    HabitatSurface surface =
        HabitatSurface(position, albedo.xyz, texelFetch(normal_texture, pixel, 0).xyz, albedo.w);
    vec3 behind = light_of_surface(surface) * airlight_habitat_transmittance(air, frame.eye_position, position);
    radiance = vec4(behind + light_of_air(frame.eye_position, direction, distance), 1.0);
}
