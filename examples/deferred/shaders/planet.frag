// The planet around the landscape into the G-buffer: the ground sphere, met by each pixel's ray.
#include "airlight/constants.glsl"
#include "airlight/view_path.glsl"
#include "airlight/viewpoint.glsl"

#include "atmosphere_block.glsl"
#include "frame.glsl"
#include "ground.glsl"

uniform bool vegetated;

layout(location = 0) out vec4 out_albedo;  // and roughness
layout(location = 1) out vec4 out_normal;

void main() {
    vec3 ray = pixel_ray(frame, ivec2(gl_FragCoord.xy));
    float ray_length = length(ray);
    vec3 direction = ray / ray_length;
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    float ground_radius = atmosphere.ground_radius;
    airlight_Viewpoint eye = airlight_viewpoint_from_surface(ground_radius, frame.eye_position, origin_up);
    airlight_ViewPath path = airlight_view_path(atmosphere, eye, direction, airlight_no_surface());
    if (!path.reaches_ground) {
        discard;
    }
    vec3 from_centre = frame.eye_position + direction * path.end;
    vec3 up = airlight_viewpoint_from_surface(ground_radius, from_centre, origin_up).up;
    float slant = max(abs(dot(up, direction)), 0.05);
    float footprint = path.end * length(frame.ray_up) / slant;
    Ground ground =
        ground_at(from_centre, up, 0.0, 1.0, footprint, ground_radius, atmosphere.ground_albedo, vegetated);
    out_albedo = vec4(ground.albedo, ground.roughness);
    out_normal = vec4(up, 0.0);
    gl_FragDepth = frame.near_distance * ray_length / path.end;
}
