#define BAKE_COLUMN
#include "airlight/diffuse_table.glsl"
#include "airlight/gathered_light.glsl"
#include "bake.glsl"
#include "diffuse.glsl"

uniform sampler2DArray light_table;

void column(vec3 uvw) {
    airlight_GatheredLight light = fetch_light(light_table, texel_at.xy);
    airlight_DiffuseTexels texels = airlight_packed_diffuse_light(light.light);
    airlight_IrradianceTexels sky = airlight_packed_sky_irradiance(light.irradiance);
    vec4 layers[10] = vec4[10](texels.mean, texels.vertical, texels.slanted, texels.across, texels.up, texels.down,
                               texels.sunward, sky.down, sky.up, sky.sunward);
    for (int k = 0; k < 10; ++k) {
        imageStore(table, ivec3(texel_at.xy, k), layers[k]);
    }
}
