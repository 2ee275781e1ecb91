#define BAKE_SECOND
#include "order_radiance.glsl"

uniform sampler3D before;

// The order's own irradiance, and the sum with the orders before.
vec4 texel(vec3 uvw) {
    airlight_AltitudeCosine p = airlight_altitude_sun_parameters(atmosphere, uvw.xy, width, height);
    vec3 irradiance = airlight_order_irradiance(atmosphere, p.altitude, p.mu);
    second = vec4(texelFetch(before, texel_at, 0).rgb + irradiance, 0.0);
    return vec4(irradiance, 0.0);
}
