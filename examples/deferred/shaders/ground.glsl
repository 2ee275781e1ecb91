// What the ground is made of, for the landscape and the planet around it alike: a function of the place, so
// that the two meet without a seam.
#include "noise.glsl"

struct Ground {
    vec3 albedo;
    float roughness;
};

// `position` is measured from the landscape's centre [m], `up` is the vertical there, `flatness` the cosine
// between the ground's normal and the vertical, `footprint` the size of a pixel on the ground [m].
Ground ground_at(vec3 position, vec3 up, float height, float flatness, float footprint, float ground_radius,
                 vec3 bare_albedo, bool vegetated) {
    // Continents are features of the whole globe; the landscape always lies on land.
    float inland = 1.0 - length(position) / 150e3;
    float land = octaves(up * ground_radius, 2500e3, 10, footprint) + 0.4 * max(inland, 0.0) + 0.05;
    float fine = octaves(position, 700.0, 10, footprint);
    float coarse = octaves(position + 3e4, 60e3, 6, footprint);

    if (!vegetated) {
        return Ground(bare_albedo * clamp(1.0 + 0.2 * land + 0.4 * fine + 0.5 * coarse, 0.3, 1.7), 1.0);
    }
    vec3 forest = vec3(0.030, 0.043, 0.020);
    vec3 meadow = vec3(0.078, 0.078, 0.040);
    vec3 soil = vec3(0.19, 0.155, 0.115);
    vec3 water = vec3(0.012, 0.028, 0.045);
    float open = smoothstep(-0.4, 0.5, 0.9 * fine + coarse + 0.2 - height / 1500.0);
    float bare =
        smoothstep(0.08, 0.25, 1.0 - flatness + 0.05 * fine) + 0.4 * smoothstep(0.2, 1.2, fine + coarse);
    vec3 albedo = mix(mix(forest, meadow, open), soil, clamp(bare, 0.0, 1.0));
    albedo *= clamp(1.0 + 0.5 * fine, 0.5, 1.5);

    // Shore: the transition is as wide as a pixel at least, so it never flickers.
    float dry = smoothstep(-0.01, 0.01, land);
    // Half rough, a shore would be a mirror as broad as it is bright; so it turns to land at once.
    return Ground(mix(water, albedo, dry), mix(0.33, 1.0, min(4.0 * dry, 1.0)));
}
