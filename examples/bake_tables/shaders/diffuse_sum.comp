#define BAKE_COLUMN
#include "airlight/gathered_light.glsl"
#include "bake.glsl"
#include "diffuse.glsl"

uniform sampler2DArray sum_table;
uniform sampler2DArray last_table;
uniform sampler2DArray next_table;
uniform int last_order;

void column(vec3 uvw) {
    airlight_GatheredLight next = fetch_light(next_table, texel_at.xy);
    vec3 share = vec3(1.0);
    if (last_order == 1) {
        vec3 last = fetch_light(last_table, texel_at.xy).light.mean;
        share = vec3(airlight_gain_of_last_order(last.x, next.light.mean.x),
                     airlight_gain_of_last_order(last.y, next.light.mean.y),
                     airlight_gain_of_last_order(last.z, next.light.mean.z));
    }
    store_light(airlight_sum_of_light(fetch_light(sum_table, texel_at.xy), share, next));
}
