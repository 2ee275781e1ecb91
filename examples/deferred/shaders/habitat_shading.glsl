// The light of a pixel in the habitat, from its G-buffer: the same formulas as habitat/shading.hpp.
#include "airlight/habitat_mapping.glsl"

uniform airlight_HabitatAir air;
uniform airlight_HabitatLights lights;
uniform sampler3D straight_table;    // by AIR_LIGHT: what passes of the strips' light, or that light itself
uniform sampler3D mean_table;        // of indirect light
uniform sampler3D irradiance_table;  // of the walls by indirect light
uniform bool indirect;

vec3 of_table(sampler3D table, vec3 position) {
    ivec3 size = textureSize(table, 0);
    vec3 unit = airlight_unit_from_habitat(air, lights, position);
    return textureLod(table, airlight_habitat_texture(unit, size.x, size.y, size.z), 0.0).xyz;
}

vec3 airlight_habitat_bare_radiance(airlight_HabitatAir air, airlight_HabitatLights lights, vec3 position);

vec3 indirect_mean(vec3 position) {
    return indirect ? of_table(mean_table, position) : vec3(0.0);
}

vec3 indirect_irradiance(vec3 position) {
    return indirect ? of_table(irradiance_table, position) : vec3(0.0);
}

// Of the strips by a table where that is how they are looked up, and of all other light.
vec3 light_at(vec3 position) {
#if AIR_LIGHT == AIR_LIGHT_NODES
    return airlight_habitat_bare_radiance(air, lights, position) * of_table(straight_table, position) +
           indirect_mean(position);
#elif AIR_LIGHT == AIR_LIGHT_MARCHED
    return of_table(straight_table, position) + indirect_mean(position);
#else
    return indirect_mean(position);
#endif
}

#define AIRLIGHT_HABITAT_LIGHT(position) light_at(position)
#define AIRLIGHT_INDIRECT_IRRADIANCE(position) indirect_irradiance(position)
#include "airlight/habitat_indirect.glsl"

struct HabitatSurface {
    vec3 position;  // [m] from the cylinder's middle
    vec3 albedo;
    vec3 normal;
    float strip;  // share of it that a strip of light fills
};

// Light that leaves the surface towards the eye.
vec3 light_of_surface(HabitatSurface surface) {
    vec3 land =
        airlight_habitat_wall_radiance(air, lights, surface.albedo, surface.position, surface.normal);
    return mix(land, lights.radiance, surface.strip);
}

// Light of the air between the eye and a surface.
vec3 light_of_air(vec3 eye, vec3 direction, float distance) {
#if AIR_LIGHT == AIR_LIGHT_PHASE
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        sum += airlight_strip_scattering(air, airlight_habitat_strip(air, lights, i), eye, direction, distance, 1);
    }
    return indirect ? sum + airlight_habitat_scattering_by_nodes(air, lights, eye, direction, distance) : sum;
#elif AIR_LIGHT == AIR_LIGHT_NODES
    return airlight_habitat_scattering_by_nodes(air, lights, eye, direction, distance);
#else
    return airlight_habitat_scattering_marched(air, lights, eye, direction, distance, MARCH_STEPS);
#endif
}
