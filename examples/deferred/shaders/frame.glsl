// What all pixels of a picture have in common: the same numbers as frame.hpp.
struct Frame {
    int width;
    int height;
    vec3 ray_corner;
    vec3 ray_across;
    vec3 ray_up;
    float near_distance;
    vec3 eye_position;
    vec3 to_sun;
    vec3 solar_irradiance;
    float sun_sin_radius;
    float sun_sin_edge;
    bool marched;
    int steps;
    int sky_steps;
};

vec3 pixel_ray(Frame frame, ivec2 pixel) {
    return frame.ray_corner + (float(pixel.x) + 0.5) * frame.ray_across +
           (float(pixel.y) + 0.5) * frame.ray_up;
}
