// What all pixels of a picture have in common: the same bytes as frame.hpp.
struct Frame {
    vec3 ray_corner;
    int width;
    vec3 ray_across;
    int height;
    vec3 ray_up;
    float near_distance;
    vec3 eye_position;
    bool marched;
    vec3 to_sun;
    int steps;
    vec3 solar_irradiance;
    int sky_steps;
    float sun_sin_radius;
    float sun_sin_edge;
    bool air;
    bool phong;
    bool lommel_seeliger;
    float star_radiance;
    float moon_sin_radius;
    float moon_irradiance;
    vec3 to_moon;
    int lights;
    float sun_seen;
    int mapped_light;
};

layout(std140) uniform FrameBlock {
    Frame frame;
};

vec3 to_mapped_light(Frame frame) {
    return frame.mapped_light == 0 ? frame.to_sun : frame.to_moon;
}

vec3 pixel_ray(Frame frame, ivec2 pixel) {
    return frame.ray_corner + (float(pixel.x) + 0.5) * frame.ray_across +
           (float(pixel.y) + 0.5) * frame.ray_up;
}
