// Where the cascades of the shadow map lie: the same bytes as passes/shadows.hpp.
struct Cascade {
    vec4 across;
    vec4 up;
    vec4 depth;
    vec4 texel;  // [m] width of a texel in x
};

layout(std140) uniform ShadowBlock {
    Cascade cascades[4];
    float shadow_range;  // [m] from the eye, beyond which no map is asked
    bool shadows_on;
};

// Where a point relative to the camera lies in a cascade, each from 0 to 1 inside.
vec3 in_cascade(int i, vec3 position) {
    vec4 p = vec4(position, 1.0);
    return vec3(dot(cascades[i].across, p), dot(cascades[i].up, p), dot(cascades[i].depth, p));
}
