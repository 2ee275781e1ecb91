#include "airlight/transmittance.glsl"
#include "airlight/table_mapping.glsl"
#include "bake.glsl"

vec4 texel(vec3 uvw) {
    airlight_AltitudeCosine at = airlight_extinction_parameters(atmosphere, uvw.xy, width, height);
    return vec4(airlight_transmittance_to_space(atmosphere, at.altitude, at.mu), 0.0);
}
