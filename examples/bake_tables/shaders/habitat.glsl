// What the passes for a habitat's tables have in common: the habitat, the place of a texel, how a table is read.

#include "airlight/atmosphere.glsl"
#include "airlight/habitat_mapping.glsl"
#include "bake.glsl"

uniform airlight_HabitatAir habitat;
uniform airlight_HabitatLights habitat_lights;

vec3 place_of(vec3 uvw) {
    return airlight_habitat_from_unit(
        habitat, habitat_lights,
        vec3(airlight_unit_from_texture(uvw.x, width), airlight_unit_from_texture(uvw.y, height),
             airlight_unit_from_texture(uvw.z, depth)));
}

vec3 read_table(sampler3D table_read, vec3 position) {
    vec3 unit = airlight_unit_from_habitat(habitat, habitat_lights, position);
    return textureLod(table_read, airlight_habitat_texture(unit, width, height, depth), 0.0).rgb;
}
