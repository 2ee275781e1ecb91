// The light that shadows keep from a ray, by the tree of its slice: whole stretches at a time that are lit or dark.
#include "epipolar.glsl"
#include "view_ray.glsl"

#include "airlight/light_shafts.glsl"

uniform sampler2D tree_texture;
uniform int pieces;

// Texel where the tree's level begins: the levels have columns, columns / 2, columns / 4, ... texels.
int level_begin(int level) {
    return 2 * columns - ((2 * columns) >> level);
}

vec3 light_lost_in_slice(ViewRay seen, int slice) {
    vec3 lost = vec3(0.0);
    vec3 to_sun = to_mapped_light(frame);
    airlight_Viewpoint eye = camera_viewpoint();
    airlight_AirRay air = airlight_air_ray(atmosphere, eye, seen.direction, min(seen.distance, shadow_range));
    if (!air.in_air) {
        return lost;
    }
    float along = dot(seen.direction, to_sun);
    float across = max(length(cross(seen.direction, to_sun)), 1e-6);
    float slope = along / across;
    int levels = findMSB(columns);

    airlight_LitRay ray = airlight_lit_ray(atmosphere, air, eye, seen.direction, to_sun);
    airlight_ShaftRay shaft = airlight_shaft_ray(atmosphere, ray);
    vec3 before = lost;
    vec3 here = airlight_source_depth(atmosphere, ray, shaft, 0.0);
    vec3 next = airlight_source_depth(atmosphere, ray, shaft,
                                      shaft.lit_length * airlight_shaft_piece_end(shaft, 1, pieces));
    int column = 0;
    int level = 0;
    for (int i = 0; i < pieces; ++i) {
        vec3 after = next;
        if (i + 1 < pieces) {
            after = airlight_source_depth(
                atmosphere, ray, shaft, shaft.lit_length * airlight_shaft_piece_end(shaft, i + 2, pieces));
        }
        airlight_ShaftPiece piece = airlight_shaft_piece(shaft, before, here, next, after, i, pieces);
        float begin = air.begin + airlight_shaft_distance(shaft, piece.begin);
        float end = air.begin + airlight_shaft_distance(shaft, piece.begin + piece.extent);
        column = clamp(int(column_of(begin * across)), 0, columns - 1);
        while (column < columns) {
            float near = column_begin(float(column));
            if (near >= end * across) {
                break;
            }
            float far = column_begin(float(column + (1 << level)));
            vec2 heights = texelFetch(tree_texture, ivec2(level_begin(level) + (column >> level), slice), 0).xy;
            float low = slope * (slope > 0.0 ? near : far);
            float high = slope * (slope > 0.0 ? far : near);
            bool lit = low >= heights.y;
            bool dark = high < heights.x;
            if (!lit && !dark && level > 0) {
                --level;
                continue;
            }
            if (!lit) {
                float from = near / across;
                float to = far / across;
                if (!dark) {
                    // One column, crossed by the ray: lit on the side where the ray is above its height.
                    float cross_at = heights.x / along;
                    from = along > 0.0 ? from : max(from, cross_at);
                    to = along > 0.0 ? min(to, cross_at) : to;
                }
                from = clamp((from - begin) / (end - begin), 0.0, 1.0);
                to = clamp((to - begin) / (end - begin), 0.0, 1.0);
                if (to > from) {
                    lost += airlight_light_between(shaft, piece, from, to);
                }
            }
            column += 1 << level;
            // Up again where a coarser texel begins.
            while (level < levels && (column & ((2 << level) - 1)) == 0) {
                ++level;
            }
        }
        level = 0;
        before = here;
        here = next;
        next = after;
    }
    return min(lost, shaft.most);
}
