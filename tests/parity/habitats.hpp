#pragma once

// Habitats, their lights and rays in them as inputs of rows.

#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitat.hpp>
#include <airlight/habitat_mapping.hpp>
#include <airlight/linear_light.hpp>
#include <tuple>

namespace parity {

/// From a hut to the size of a moon; without spin, with a wall as heavy as the ground, and ten times as fast.
inline airlight::HabitatAir<float> habitat(Draw& draw) {
    const float radius = draw.magnitude(10.0F, 1e6F, {8e3F});
    const float rise = draw.magnitude(1e-4F, 40.0F, {0.0F, 0.47F}) / (radius * radius);
    const float thick = draw.magnitude(1e-3F, 30.0F, {0.0F}) / radius;
    const auto rayleigh = thick * draw.spectrum(0.1F, 1.0F);
    const auto mie = thick * draw.spectrum(0.1F, 1.0F);
    const auto absorbed = thick * draw.spectrum(0.01F, 0.1F);
    const float g = draw.aerosol_parameter();
    return airlight::HabitatAir<float>{radius, rise, rayleigh, mie, absorbed, g};
}

/// Inside the wall, or on it; up to three radii along the axis.
inline airlight::vec3<float> place_in(Draw& draw, const airlight::HabitatAir<float>& air) {
    const auto direction = draw.direction();
    const float away = draw.number(0.0F, 1.0F);
    const float along = draw.number(-3.0F, 3.0F);
    return air.radius * airlight::vec3<float>(along, away * direction.y, away * direction.z);
}

/// Eye, direction and distance of a ray that stays off the wall and off the planes of the strips' ends: its
/// nodes move by what exp is off.
inline auto ray_in(Draw& draw, const airlight::HabitatAir<float>& air) {
    const auto off = airlight::vec3<float>(0.98F, 0.97F, 0.97F);
    const auto eye = off * place_in(draw, air);
    const auto way = off * place_in(draw, air) - eye;
    const float length = glm::sqrt(glm::dot(way, way));
    const auto ahead = airlight::vec3<float>(1.0F, 0.0F, 0.0F);
    return std::make_tuple(eye, length > 0.0F ? way / length : ahead, length);
}

/// On the wall, along the axis, shining inwards.
inline airlight::LinearLight<float> strip_in(Draw& draw, const airlight::HabitatAir<float>& air) {
    const float half_length = draw.magnitude(1e-3F, 2.0F, {0.7F}) * air.radius;
    const float width = draw.magnitude(1e-4F, 0.1F, {0.0125F}) * air.radius;
    const float along = draw.number(-1.0F, 1.0F) * air.radius;
    const auto radiance = draw.spectrum(0.1F, 10.0F);
    return airlight::LinearLight<float>{airlight::vec3<float>(along, 0.0F, -air.radius),
                                        airlight::vec3<float>(1.0F, 0.0F, 0.0F),
                                        airlight::vec3<float>(0.0F, 0.0F, 1.0F),
                                        half_length,
                                        width,
                                        radiance};
}

/// Why a ray among six strips may be left out of a comparison.
inline constexpr const char* nearest_strip =
    "which of six strips a ray comes nearest to, and where: often two are as near";

/// On the inner side of a strip, from a fiftieth of its width to 20 widths off.
inline auto strip_and_place_near_it(Draw& draw, const airlight::HabitatAir<float>& air) {
    const auto light = strip_in(draw, air);
    const float along = draw.number(-1.2F, 1.2F, {0.0F}) * light.half_length;
    const float across = draw.number(-4.0F, 4.0F, {0.0F}) * light.width;
    const float height = draw.magnitude(0.02F, 20.0F) * light.width;
    const auto off = airlight::vec3<float>(along, across, height);
    return std::make_tuple(light, light.centre + off);
}

/// Six strips of the document's proportions, and others.
inline airlight::HabitatLights<float> lights_in(Draw& draw, const airlight::HabitatAir<float>& air) {
    const float half_length = air.radius * draw.magnitude(1.0F, 10.0F, {3.0F});
    const float begin = half_length * draw.number(0.2F, 0.4F);
    const float end = half_length * draw.number(0.6F, 0.8F);
    const float width = draw.magnitude(1e-3F, 0.1F, {0.0125F}) * air.radius;
    const auto radiance = draw.spectrum(0.1F, 10.0F);
    const float fine = half_length * draw.number(0.001F, 0.05F);
    return airlight::HabitatLights<float>{
        half_length, begin, end, width, radiance, fine, draw.number(0.01F, 0.09F)};
}

}  // namespace parity
