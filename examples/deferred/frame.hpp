#pragma once

#include <cmath>
#include <cstddef>

#include <glm/glm.hpp>

#include <airlight/types.hpp>

namespace deferred {

using vec3 = airlight::vec3<float>;

/// What all pixels of a picture have in common. The shaders get these bytes as the block `FrameBlock`, so
/// the members lie as std140 has them: a vec3 on 16 bytes, what follows it in its fourth float.
struct Frame {
    // The view. The ray through the middle of pixel (x, y), counted from the lower left, is
    // ray_corner + (x + 1/2) ray_across + (y + 1/2) ray_up; along the view axis it has length 1.
    alignas(16) vec3 ray_corner;
    int width;
    alignas(16) vec3 ray_across;
    int height;
    alignas(16) vec3 ray_up;
    float near_distance;            ///< [m] along the view axis; stored depth = near / that of the surface
    alignas(16) vec3 eye_position;  ///< [m] from the landscape's centre at altitude 0; x east, z up
    int marched;                    ///< air by single_scattering_marched; else by single_scattering
    alignas(16) vec3 to_sun;
    int steps;                          ///< of the march between the eye and a surface
    alignas(16) vec3 solar_irradiance;  ///< above the air; the unit of every radiance is this one's per sr
    int sky_steps;                      ///< of the march up from a surface, for its skylight
    float sun_sin_radius;               ///< sine of the sun's angular radius
    float sun_sin_edge;   ///< sine of the angle its rim is spread by to both sides: half a pixel
    int air;              ///< 0: as if there were none
    int phong;            ///< the glint after Phong, else of microfacets
    int lommel_seeliger;  ///< the ground after Lommel and Seeliger, else after Lambert
    float star_radiance;  ///< [1/sr] of a star of magnitude 0 that fills the picture's middle pixel
    float moon_sin_radius;
    float moon_irradiance;  ///< of the moon's light above the air; the sun's is 1
    alignas(16) vec3 to_moon;
    int lights;        ///< 1: the sun; 2: the moon too
    float sun_seen;    ///< share of the sun that the moon leaves
    int mapped_light;  ///< which of the lights the shadow maps are of
};

/// Towards the light that the shadow maps are of.
inline const vec3& to_mapped_light(const Frame& frame) {
    return frame.mapped_light == 0 ? frame.to_sun : frame.to_moon;
}

/// Axes that hang on a light's direction alone.
struct LightAxes {
    glm::dvec3 to_light;
    glm::dvec3 across;
    glm::dvec3 up;
};

inline LightAxes mapped_light_axes(const Frame& frame) {
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(to_mapped_light(frame)));
    const glm::dvec3 other = std::abs(to_light.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(other, to_light));
    return {to_light, across, glm::cross(to_light, across)};
}

static_assert(offsetof(Frame, ray_across) == 16 && offsetof(Frame, eye_position) == 48 &&
                  offsetof(Frame, solar_irradiance) == 80 && offsetof(Frame, sky_steps) == 92 &&
                  offsetof(Frame, sun_sin_radius) == 96 && offsetof(Frame, lommel_seeliger) == 112 &&
                  offsetof(Frame, star_radiance) == 116 && offsetof(Frame, to_moon) == 128 &&
                  offsetof(Frame, mapped_light) == 148,
              "Frame must lie as std140 has it, see shaders/frame.glsl");

}  // namespace deferred
