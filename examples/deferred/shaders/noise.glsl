// Noise that is a function of the place alone.
uint scrambled(uint x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

float random_at(ivec3 cell) {
    uint h = scrambled(uint(cell.x) + scrambled(uint(cell.y) + scrambled(uint(cell.z))));
    return float(h >> 8u) / 16777216.0;
}

// Smooth noise in [-1, 1] with features of size 1.
float noise(vec3 p) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - floor(p);
    f = f * f * (3.0 - 2.0 * f);
    float value = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 share = mix(1.0 - f, f, vec3(corner));
        value += share.x * share.y * share.z * random_at(cell + corner);
    }
    return 2.0 * value - 1.0;
}

// Octaves of noise from features of `size` on; those too small for a pixel of `footprint` fade out.
float octaves(vec3 p, float size, int count, float footprint) {
    float sum = 0.0;
    float amplitude = 0.5;
    for (int i = 0; i < count; ++i) {
        float share = clamp(0.5 * size / footprint - 1.0, 0.0, 1.0);
        if (share > 0.0) {
            sum += share * amplitude * noise(p / size + float(17 * i));
        }
        amplitude *= 0.6;
        size *= 0.5;
    }
    return sum;
}
