#include "airlight/hillaire_table.glsl"
#include "bake.glsl"

uniform int zeniths;
uniform int azimuths;
uniform int steps;

vec4 texel(vec3 uvw) {
    airlight_AltitudeCosine at = airlight_altitude_sun_parameters(atmosphere, uvw.xy, width, height);
    return vec4(airlight_hillaire_texel(atmosphere, at.altitude, at.mu, zeniths, azimuths, steps), 0.0);
}
