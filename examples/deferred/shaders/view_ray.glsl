// The ray of a pixel up to what it shows, and the viewpoint of the camera. Needs atmosphere and frame.
#include "airlight/constants.glsl"
#include "airlight/viewpoint.glsl"

struct ViewRay {
    vec3 direction;
    float distance;  // [m] airlight_no_surface() where there is none
};

ViewRay view_ray(ivec2 pixel, float depth) {
    vec3 ray = pixel_ray(frame, pixel);
    float ray_length = length(ray);
    return ViewRay(ray / ray_length,
                   depth > 0.0 ? frame.near_distance / depth * ray_length : airlight_no_surface());
}

airlight_Viewpoint camera_viewpoint() {
    vec3 origin_up = vec3(0.0, 0.0, 1.0);
    return airlight_viewpoint_from_surface(atmosphere.ground_radius, frame.eye_position, origin_up);
}
