#include "airlight/sky_view_table.glsl"
#include "bake.glsl"

uniform float eye_altitude;
uniform float mu_s;

vec4 texel(vec3 uvw) {
    airlight_SkyDirection seen =
        airlight_sky_view_parameters(atmosphere.ground_radius, eye_altitude, uvw.xy, width, height);
    return vec4(airlight_sky_view_texel(atmosphere, eye_altitude, mu_s, seen), 0.0);
}
