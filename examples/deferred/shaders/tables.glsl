// Where the light that single scattering does not have comes from: tables.hpp and shading.hpp in GLSL. The hooks
// are defined before the functions that call them are included.
#define TABLES_NONE 0
#define TABLES_TRANSMITTANCE 1
#define TABLES_INSCATTER3D 2
#define TABLES_HILLAIRE 3
#define TABLES_BRUNETON 4
#define TABLES_DIFFUSE 5
#ifndef TABLES
#define TABLES TABLES_NONE
#endif

layout(std140) uniform AtmosphereBlock {
    airlight_Atmosphere atmosphere;
};
uniform sampler3D table_0;
uniform sampler3D table_1;
uniform sampler3D table_2;

#if TABLES == TABLES_TRANSMITTANCE
// A flat table: its one slice.
#define AIRLIGHT_SLANT_TABLE(uv) texture(table_0, vec3(uv, 0.5)).xy
#endif
// None of these calls a hook that is defined below. A file is included once, so never inside an #if.
#include "airlight/diffuse_table.glsl"
#include "airlight/scattering_mapping.glsl"
#include "airlight/transmittance_table.glsl"

#if TABLES == TABLES_TRANSMITTANCE
vec3 from_slants(airlight_Atmosphere air, float altitude, float mu) {
    ivec3 size = textureSize(table_0, 0);
    return airlight_transmittance_from_slants(air, altitude, mu, size.x, size.y);
}
#define AIRLIGHT_TRANSMITTANCE_TO_SPACE(altitude, mu) from_slants(atmosphere, altitude, mu)
#endif

#if TABLES == TABLES_HILLAIRE
airlight_DiffuseLight light_from_all_sides(float altitude, float mu_s) {
    ivec3 size = textureSize(table_0, 0);
    vec2 uv = airlight_altitude_sun_uv(atmosphere, altitude, mu_s, size.x, size.y);
    return airlight_even_light(texture(table_0, vec3(uv, 0.5)).xyz);
}
#define AIRLIGHT_MULTIPLE_SCATTERING(altitude, mu_s) light_from_all_sides(altitude, mu_s)
#endif

#if TABLES == TABLES_DIFFUSE
// Layers are slices, read at their centres.
vec4 layer(vec2 uv, int k) {
    return texture(table_0, vec3(uv, (float(k) + 0.5) / 10.0));
}
airlight_DiffuseLight light_from_all_sides(float altitude, float mu_s) {
    ivec3 size = textureSize(table_0, 0);
    vec2 uv = airlight_diffuse_table_uv(atmosphere, altitude, mu_s, size.x, size.y);
    return airlight_unpacked_diffuse_light(airlight_DiffuseTexels(
        layer(uv, 0), layer(uv, 1), layer(uv, 2), layer(uv, 3), layer(uv, 4), layer(uv, 5), layer(uv, 6)));
}
airlight_SkyIrradiance light_on_surfaces(float altitude, float mu_s) {
    ivec3 size = textureSize(table_0, 0);
    vec2 uv = airlight_diffuse_table_uv(atmosphere, altitude, mu_s, size.x, size.y);
    return airlight_unpacked_sky_irradiance(
        airlight_IrradianceTexels(layer(uv, 7), layer(uv, 8), layer(uv, 9)));
}
#define AIRLIGHT_MULTIPLE_SCATTERING(altitude, mu_s) light_from_all_sides(altitude, mu_s)
#endif

#if TABLES == TABLES_INSCATTER3D || TABLES == TABLES_BRUNETON
#if TABLES == TABLES_BRUNETON
uniform ivec4 scattering_size;  // nu, sun, view, altitude
vec3 from_table(sampler3D table, float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    airlight_ScatteringLookup at = airlight_scattering_lookup(
        atmosphere, altitude, mu, mu_s, nu, reaches_ground, airlight_lowest_sun_cosine(atmosphere),
        scattering_size.x, scattering_size.y, scattering_size.z, scattering_size.w);
    return texture(table, at.first).xyz * (1.0 - at.weight) + texture(table, at.second).xyz * at.weight;
}
#else
vec3 from_table(sampler3D table, float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    ivec3 size = textureSize(table, 0);
    return texture(table, airlight_inscatter_uvw(atmosphere, altitude, mu, mu_s, reaches_ground,
                                                 airlight_lowest_sun_cosine(atmosphere), size.x, size.y, size.z))
        .xyz;
}
#endif
#define AIRLIGHT_SCATTERED_RAYLEIGH(altitude, mu, mu_s, nu, ground) from_table(table_0, altitude, mu, mu_s, nu, ground)
#define AIRLIGHT_SCATTERED_MIE(altitude, mu, mu_s, nu, ground) from_table(table_1, altitude, mu, mu_s, nu, ground)
#define AIRLIGHT_MULTIPLE_RADIANCE(altitude, mu, mu_s, nu, ground) from_table(table_2, altitude, mu, mu_s, nu, ground)
#endif
