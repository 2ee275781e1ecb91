#include "airlight/transmittance.glsl"
#include "airlight/table_mapping.glsl"
#include "bake.glsl"

vec4 texel(vec3 uvw) {
    airlight_AltitudeCosine at = airlight_transmittance_parameters(atmosphere, uvw.xy, width, height);
    return vec4(airlight_transmittance(atmosphere, at.altitude, at.mu, airlight_no_surface()), 0.0);
}
