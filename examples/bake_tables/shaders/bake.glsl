// Around every pass: one call of texel() for each texel of the tables it fills. A pass with two tables defines
// BAKE_SECOND and sets `second` in texel().

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) writeonly uniform image3D table;
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
vec4 texel(vec3 uvw);

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID.xy, slice);
    if (at.x >= width || at.y >= height) {
        return;
    }
    texel_at = at;
    vec3 uvw = vec3((float(at.x) + 0.5) / float(width), (float(at.y) + 0.5) / float(height),
                    (float(at.z) + 0.5) / float(depth));
    imageStore(table, at, texel(uvw));
#ifdef BAKE_SECOND
    imageStore(second_table, at, second);
#endif
}
