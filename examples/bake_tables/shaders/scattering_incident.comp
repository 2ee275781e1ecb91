#include "order_radiance.glsl"

// x is the sun, y the altitude, z the direction: side, polar angle, azimuth.
vec4 texel(vec3 uvw) {
#ifdef BAKE_FOUR_DIMENSIONS
    vec3 place = vec3((float(texel_at.x) + 0.5) / float(nus * suns), 0.5 / float(views), uvw.y);
#else
    vec3 place = vec3(uvw.y, 0.5 / float(views), uvw.x);
#endif
    airlight_ScatteringPoint p = point_of(place);
    int side = texel_at.z / (AIRLIGHT_NODES * 16);
    int polar = texel_at.z / 16 - side * AIRLIGHT_NODES;
    return vec4(airlight_incident_light(atmosphere, p.altitude, p.mu_s, side, polar, texel_at.z % 16), 0.0);
}
