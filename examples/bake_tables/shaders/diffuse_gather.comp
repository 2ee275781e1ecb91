#define BAKE_COLUMN
#include "airlight/diffuse_table.glsl"

// The order before, as the hooks of the library ask for it.
airlight_DiffuseLight light_before(float altitude, float mu_s);
vec3 irradiance_before(float mu_s);
#define AIRLIGHT_MULTIPLE_SCATTERING(altitude, mu_s) light_before(altitude, mu_s)
#define AIRLIGHT_GROUND_IRRADIANCE(mu_s) irradiance_before(mu_s)
#include "airlight/gathered_light.glsl"
#include "bake.glsl"
#include "diffuse.glsl"

uniform sampler2DArray before_table;
uniform int first_order;

vec4 layer_at(vec2 uv, int layer) {
    return textureLod(before_table, vec3(uv, float(layer)), 0.0);
}
airlight_DiffuseLight light_before(float altitude, float mu_s) {
    vec2 uv = airlight_diffuse_table_uv(atmosphere, altitude, mu_s, width, height);
    return airlight_unpacked_diffuse_light(airlight_DiffuseTexels(
        layer_at(uv, 0), layer_at(uv, 1), layer_at(uv, 2), layer_at(uv, 3), layer_at(uv, 4), layer_at(uv, 5),
        layer_at(uv, 6)));
}
vec3 irradiance_before(float mu_s) {
    vec2 uv = airlight_diffuse_table_uv(atmosphere, 0.0, mu_s, width, height);
    return airlight_unpacked_sky_irradiance(
               airlight_IrradianceTexels(layer_at(uv, 7), layer_at(uv, 8), layer_at(uv, 9))).down;
}

void column(vec3 uvw) {
    airlight_AltitudeCosine point = airlight_diffuse_table_parameters(atmosphere, uvw.xy, width, height);
    store_light(airlight_gathered_light(atmosphere, point.altitude, point.mu, first_order == 1));
}
