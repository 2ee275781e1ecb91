// What the steps of the bloom's pyramid have in common. Every texel covers 2 x 2 of the level below, whatever the
// sizes; past its edges a picture goes on as its mirror image, so that no light is lost there.

ivec2 mirrored(ivec2 place, ivec2 size) {
    ivec2 p = abs(2 * place + 1) / 2;
    p = p % (2 * size);
    return min(p, 2 * size - 1 - p);
}

// Eight times the sun's disc: what is brighter does not glow more, and infinities do not spread.
vec3 bounded(vec3 radiance) {
    return mix(vec3(0.0), min(radiance, vec3(1.5e5)), greaterThan(radiance, vec3(0.0)));
}

// A level brought up to twice its size: between its texels bilinear, smoothed by a tent of 3 x 3 (Jimenez 2014).
// Both together weigh 4 x 4 texels.
vec3 brought_up(sampler2D level, ivec2 pixel) {
    const float weights[4] = float[4](1.0 / 16.0, 5.0 / 16.0, 7.0 / 16.0, 3.0 / 16.0);
    ivec2 size = textureSize(level, 0);
    ivec2 odd = pixel & 1;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            // On the other side of a texel the weights count from its other side.
            ivec2 step = ivec2(x, y) - 2;
            ivec2 place = pixel / 2 + step * (1 - 2 * odd);
            sum += weights[x] * weights[y] * texelFetch(level, mirrored(place, size), 0).xyz;
        }
    }
    return sum;
}
