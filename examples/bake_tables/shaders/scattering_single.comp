#define BAKE_SECOND
#include "airlight/scattering_orders.glsl"
#include "airlight/scattering_mapping.glsl"
#include "bake.glsl"
#include "scattering.glsl"

vec4 texel(vec3 uvw) {
    airlight_ScatteringPoint p = point_of(uvw);
    airlight_InScatter light =
        airlight_single_inscatter(atmosphere, p.altitude, p.mu, p.mu_s, p.nu, p.reaches_ground);
    second = vec4(light.mie, 0.0);
    return vec4(light.rayleigh, 0.0);
}
