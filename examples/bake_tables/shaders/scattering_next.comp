#define BAKE_SECOND
vec3 gathered_rayleigh(float altitude, float mu, float mu_s, float nu, bool reaches_ground);
vec3 gathered_mie(float altitude, float mu, float mu_s, float nu, bool reaches_ground);
#define AIRLIGHT_GATHERED_RAYLEIGH(altitude, mu, mu_s, nu, ground) gathered_rayleigh(altitude, mu, mu_s, nu, ground)
#define AIRLIGHT_GATHERED_MIE(altitude, mu, mu_s, nu, ground) gathered_mie(altitude, mu, mu_s, nu, ground)
#include "airlight/scattering_orders.glsl"
#include "airlight/scattering_mapping.glsl"
#include "bake.glsl"
#include "scattering.glsl"

uniform sampler3D gathered_rayleigh_table;
uniform sampler3D gathered_mie_table;
uniform sampler3D before;

vec3 gathered_rayleigh(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return read_table(gathered_rayleigh_table, altitude, mu, mu_s, nu, reaches_ground);
}
vec3 gathered_mie(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return read_table(gathered_mie_table, altitude, mu, mu_s, nu, reaches_ground);
}

// The order itself, and the sum with the orders before.
vec4 texel(vec3 uvw) {
    airlight_ScatteringPoint p = point_of(uvw);
    vec3 radiance =
        airlight_next_order_radiance(atmosphere, p.altitude, p.mu, p.mu_s, p.nu, p.reaches_ground);
    second = vec4(texelFetch(before, texel_at, 0).rgb + radiance, 0.0);
    return vec4(radiance, 0.0);
}
