#include "airlight/habitat_scattering.glsl"
#include "habitat.glsl"

uniform int pieces;

vec4 texel(vec3 uvw) {
    return vec4(airlight_habitat_mean_passed(habitat, habitat_lights, place_of(uvw), pieces), 0.0);
}
