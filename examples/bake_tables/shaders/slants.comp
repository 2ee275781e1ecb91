#include "airlight/transmittance_table.glsl"
#include "bake.glsl"

vec4 texel(vec3 uvw) {
    airlight_AltitudeCosine at = airlight_slant_parameters(atmosphere, uvw.xy, width, height);
    return vec4(airlight_slant_texel(atmosphere, at.altitude, at.mu), 0.0, 0.0);
}
