#define BAKE_SECOND
vec3 incident(int side, int polar, int azimuth);
#define AIRLIGHT_INCIDENT_LIGHT(altitude, mu_s, side, polar, azimuth) incident(side, polar, azimuth)
#include "airlight/scattering_orders.glsl"
#include "airlight/scattering_mapping.glsl"
#include "bake.glsl"
#include "scattering.glsl"

uniform sampler3D incident_table;

// The light is the same for all views of this texel's altitude and sun.
vec3 incident(int side, int polar, int azimuth) {
#ifdef BAKE_FOUR_DIMENSIONS
    ivec2 at = ivec2(texel_at.x % suns, texel_at.z);
#else
    ivec2 at = texel_at.zx;
#endif
    return texelFetch(incident_table, ivec3(at, (side * AIRLIGHT_NODES + polar) * 16 + azimuth), 0).rgb;
}

vec4 texel(vec3 uvw) {
    airlight_ScatteringPoint p = point_of(uvw);
    airlight_PhaseWeighted light = airlight_phase_weighted_light(atmosphere, p.altitude, p.mu, p.mu_s, p.nu);
    second = vec4(light.mie, 0.0);
    return vec4(light.rayleigh, 0.0);
}
