#define BAKE_SECOND
vec3 light_before(vec3 position);
vec3 irradiance_before(vec3 position);
#define AIRLIGHT_HABITAT_LIGHT(position) light_before(position)
#define AIRLIGHT_INDIRECT_IRRADIANCE(position) irradiance_before(position)
#include "airlight/habitat_indirect.glsl"
#include "habitat.glsl"

uniform vec3 albedo;
uniform int directions;
uniform sampler3D passed_table;
uniform sampler3D mean_table;
uniform sampler3D irradiance_table;

vec3 light_before(vec3 position) {
    return airlight_habitat_bare_radiance(habitat, habitat_lights, position) * read_table(passed_table, position) +
           read_table(mean_table, position);
}
vec3 irradiance_before(vec3 position) {
    return read_table(irradiance_table, position);
}

// One bounce further than the tables that are read.
vec4 texel(vec3 uvw) {
    airlight_HabitatIndirect light =
        airlight_gathered_habitat_light(habitat, habitat_lights, albedo, place_of(uvw), directions);
    second = vec4(light.irradiance, 0.0);
    return vec4(light.mean, 0.0);
}
