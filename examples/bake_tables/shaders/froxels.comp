#define BAKE_SECOND
#include "airlight/froxel_table.glsl"
#include "bake.glsl"

uniform airlight_Viewpoint eye;
uniform airlight_CameraRays camera;
uniform vec3 to_sun;
uniform float max_distance;
uniform int slices;

vec4 texel(vec3 uvw) {
    airlight_FroxelPoint at = airlight_froxel_parameters(uvw, max_distance, slices, width, height, depth);
    airlight_FroxelAir air =
        airlight_froxel_texel(atmosphere, eye, airlight_camera_direction(camera, at.screen), to_sun, at.distance);
    second = vec4(air.depth, 0.0);
    return vec4(air.radiance, 0.0);
}
