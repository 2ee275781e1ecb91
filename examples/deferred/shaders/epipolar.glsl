// Slices of the air: half planes that hold the eye and the sun. A direction lies in one slice, at an angle from the
// sun; in a slice all that shades the air is one height over one distance. The same bytes as passes/epipolar.hpp.
layout(std140) uniform EpipolarBlock {
    vec3 slice_x;        // across the sunlight, where a slice's angle is 0
    float first_slice;   // [rad] angle of the first slice around the sun
    vec3 slice_y;
    float slice_range;   // [rad] between the first slice and the last
    float first_angle;   // [rad] from the sun, of a slice's first sample
    float angle_range;   // [rad] between the first sample and the last
    float columns_end;   // [m] across the sunlight, where the last column ends
    bool whole_circle;   // the last slice is next to the first
    int slices;
    int samples;
    int columns;
};

// Column k of a slice covers the distances across the sunlight from here to that of k + 1: ever wider ones, as the
// cascades' texels are.
float column_begin(float k) {
    float x = k / float(columns);
    return columns_end * (x * x);
}

float column_of(float across) {
    return float(columns) * sqrt(clamp(across / columns_end, 0.0, 1.0));
}

vec3 slice_direction(float slice) {
    float step = slice_range / float(whole_circle ? slices : slices - 1);
    float angle = first_slice + slice * step;
    return cos(angle) * slice_x + sin(angle) * slice_y;
}

float sample_angle(float number) {
    return first_angle + angle_range * number / float(samples - 1);
}

// A direction's place: number of its sample, number of its slice.
vec2 epipolar_place(vec3 direction, vec3 to_sun) {
    vec2 across = vec2(dot(direction, slice_x), dot(direction, slice_y));
    float angle = atan(length(across), dot(direction, to_sun));
    float around = atan(across.y, across.x) - first_slice;
    around -= 6.28318530718 * floor(around / 6.28318530718);
    float step = slice_range / float(whole_circle ? slices : slices - 1);
    // Just before the first slice, where the circle is not whole.
    if (!whole_circle && around > 0.5 * (slice_range + 6.28318530718)) {
        around -= 6.28318530718;
    }
    return vec2((angle - first_angle) / angle_range * float(samples - 1), around / step);
}
