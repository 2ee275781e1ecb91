// Around every pass: one call of texel(uvw) for each texel of the table it fills. A pass with two tables
// defines BAKE_SECOND and sets `second` in texel(). One that defines BAKE_COLUMN fills a table in layers: it has
// column(uvw) instead, which stores every layer at texel_at.xy itself.

layout(local_size_x = 8, local_size_y = 8) in;
#ifdef BAKE_COLUMN
layout(rgba32f, binding = 0) writeonly uniform image2DArray table;
#else
layout(rgba32f, binding = 0) writeonly uniform image3D table;
#endif
#ifdef BAKE_SECOND
layout(rgba32f, binding = 1) writeonly uniform image3D second_table;
vec4 second;
#endif

uniform int width;
uniform int height;
uniform int depth;
uniform int slice;
uniform airlight_Atmosphere atmosphere;

ivec3 texel_at;  // which texel it is
#ifdef BAKE_COLUMN
void column(vec3 uvw);
#else
vec4 texel(vec3 uvw);
#endif

void main() {
    texel_at = ivec3(gl_GlobalInvocationID.xy, slice);
    if (texel_at.x >= width || texel_at.y >= height) {
        return;
    }
    vec3 uvw = vec3((float(texel_at.x) + 0.5) / float(width), (float(texel_at.y) + 0.5) / float(height),
                    (float(texel_at.z) + 0.5) / float(depth));
#ifdef BAKE_COLUMN
    column(uvw);
#else
    imageStore(table, texel_at, texel(uvw));
#endif
#ifdef BAKE_SECOND
    imageStore(second_table, texel_at, second);
#endif
}
