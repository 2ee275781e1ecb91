// Light of the order before, as the hooks of the library ask for it: from the tables of single scattering
// (BAKE_FIRST_ORDER), or from the table of that order.

vec3 order_radiance(float altitude, float mu, float mu_s, float nu, bool reaches_ground);
vec3 scattered_rayleigh(float altitude, float mu, float mu_s, float nu, bool reaches_ground);
vec3 scattered_mie(float altitude, float mu, float mu_s, float nu, bool reaches_ground);
vec3 order_irradiance(float mu_s);
#define AIRLIGHT_ORDER_RADIANCE(altitude, mu, mu_s, nu, ground) order_radiance(altitude, mu, mu_s, nu, ground)
#define AIRLIGHT_SCATTERED_RAYLEIGH(altitude, mu, mu_s, nu, ground) scattered_rayleigh(altitude, mu, mu_s, nu, ground)
#define AIRLIGHT_SCATTERED_MIE(altitude, mu, mu_s, nu, ground) scattered_mie(altitude, mu, mu_s, nu, ground)
#define AIRLIGHT_ORDER_IRRADIANCE(mu_s) order_irradiance(mu_s)

#include "airlight/scattering_of_table.glsl"
#include "airlight/scattering_orders.glsl"
#include "airlight/scattering_mapping.glsl"
#include "bake.glsl"
#include "scattering.glsl"

#ifdef BAKE_FIRST_ORDER
uniform sampler3D rayleigh_table;
uniform sampler3D mie_table;

vec3 scattered_rayleigh(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return read_table(rayleigh_table, altitude, mu, mu_s, nu, reaches_ground);
}
vec3 scattered_mie(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return read_table(mie_table, altitude, mu, mu_s, nu, reaches_ground);
}
vec3 order_radiance(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return airlight_radiance_of_table(atmosphere, altitude, mu, mu_s, nu, reaches_ground);
}
vec3 order_irradiance(float mu_s) {
    return airlight_direct_irradiance(atmosphere, 0.0, mu_s);
}
#else
uniform sampler3D order_table;
uniform sampler3D irradiance_table;

vec3 scattered_rayleigh(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return vec3(0.0);
}
vec3 scattered_mie(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return vec3(0.0);
}
vec3 order_radiance(float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    return read_table(order_table, altitude, mu, mu_s, nu, reaches_ground);
}
vec3 order_irradiance(float mu_s) {
    ivec3 size = textureSize(irradiance_table, 0);
    vec2 at = airlight_altitude_sun_uv(atmosphere, 0.0, mu_s, size.x, size.y);
    return textureLod(irradiance_table, vec3(at, 0.5), 0.0).rgb;
}
#endif
