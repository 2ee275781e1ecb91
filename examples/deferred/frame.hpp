#pragma once

#include <airlight/types.hpp>

namespace deferred {

using vec3 = airlight::vec3<float>;

/// What all pixels of a picture have in common. The shaders get the same numbers, as `uniform Frame frame`.
struct Frame {
    int width;
    int height;
    // The view. The ray through the middle of pixel (x, y), counted from the lower left, is
    // ray_corner + (x + 1/2) ray_across + (y + 1/2) ray_up; along the view axis it has length 1.
    vec3 ray_corner;
    vec3 ray_across;
    vec3 ray_up;
    float near_distance;  ///< [m] along the view axis; stored depth = near_distance / that of the surface
    vec3 eye_position;    ///< [m] from the landscape's centre at altitude 0; x east, y north, z up
    // The sun.
    vec3 to_sun;
    vec3 solar_irradiance;  ///< above the air; the unit of every radiance is this one's per sr
    float sun_sin_radius;   ///< sine of the sun's angular radius
    float sun_sin_edge;     ///< sine of the angle by which its rim is spread to both sides, half a pixel's
    bool marched;  ///< air by single_scattering_marched, in so many steps per ray; else by single_scattering
    int steps;
    int sky_steps;
};

}  // namespace deferred
