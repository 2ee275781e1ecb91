// A layer of clouds between two heights: where a ray meets it, and how dense it is.
#include "airlight/ray_sphere.glsl"
#include "airlight/viewpoint.glsl"

#include "noise.glsl"

const float cloud_base = 1800.0;        // [m]
const float cloud_top = 2200.0;         // [m]
const float cloud_extinction = 0.06;    // [1/m] where it is densest

// Where a ray is between the two heights, at most twice; empty where begin >= end.
struct CloudStretches {
    vec2 first;
    vec2 second;
};

CloudStretches cloud_stretches(float ground_radius, airlight_Viewpoint eye, vec3 direction, float distance) {
    float mu = clamp(airlight_dot_product(eye.up, direction), -1.0, 1.0);
    airlight_RaySphereHit top =
        airlight_intersect_ray_sphere(ground_radius + cloud_top, eye.altitude - cloud_top, mu);
    airlight_RaySphereHit base =
        airlight_intersect_ray_sphere(ground_radius + cloud_base, eye.altitude - cloud_base, mu);
    vec2 none = vec2(0.0);
    if (!top.hit || top.t_far <= 0.0) {
        return CloudStretches(none, none);
    }
    vec2 all = clamp(vec2(top.t_near, top.t_far), 0.0, distance);
    if (!base.hit || base.t_far <= 0.0) {
        return CloudStretches(all, none);
    }
    vec2 below = clamp(vec2(base.t_near, base.t_far), 0.0, distance);
    return CloudStretches(vec2(all.x, below.x), vec2(below.y, all.y));
}

// Extinction [1/m] at a place, measured from the landscape's centre; what is smaller than the footprint [m] is
// smoothed away.
float cloud_density(float ground_radius, vec3 position, float footprint) {
    float altitude = airlight_viewpoint_from_surface(ground_radius, position, vec3(0.0, 0.0, 1.0)).altitude;
    float x = (altitude - cloud_base) / (cloud_top - cloud_base);
    if (x <= 0.0 || x >= 1.0) {
        return 0.0;
    }
    // Clouds are clusters of heaps, with flat feet and round heads.
    float weather = octaves(position + 3e5, 900e3, 6, footprint);
    float heap = octaves(position, 6e3, 6, footprint);
    float edge = 0.7 * weather + heap + 0.02 - 0.5 * x * x - 0.1 * (1.0 - x);
    // Where heaps are smaller than a pixel their mean is left, which has soft edges.
    float soft = mix(0.06, 0.25, smoothstep(300.0, 6000.0, footprint));
    return cloud_extinction * smoothstep(-soft, soft, edge) * smoothstep(0.0, 0.1, x) *
           smoothstep(1.0, 0.9, x);
}

// The optical depth of a stretch by a few looks, the closer together the nearer to its begin.
float cloud_depth(float ground_radius, vec3 origin, vec3 direction, vec2 stretch, int looks, float footprint) {
    float extent = stretch.y - stretch.x;
    float sum = 0.0;
    for (int i = 0; i < looks; ++i) {
        float s = (float(i) + 0.5) / float(looks);
        float width = 2.0 * s * extent / float(looks);
        sum += width * cloud_density(ground_radius, origin + direction * (stretch.x + s * s * extent),
                                     max(footprint, 0.5 * width));
    }
    return sum;
}

// What a layer of droplets lets through, scattered on the way or not: they scatter forwards and absorb nothing
// (two streams, asymmetry 0.85).
float cloud_light_through(float depth) {
    return 1.0 / (1.0 + 0.75 * (1.0 - 0.85) * depth);
}
