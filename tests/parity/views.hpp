#pragma once

// View rays as inputs of rows.

#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/single_scattering.hpp>

namespace parity {

/// Why rows of view rays leave inputs out.
inline constexpr const char* grazing =
    "rays that graze the top of the air exactly, and suns exactly behind or across the ray, are end points "
    "where rounding decides how long the ray or its shadow is";

/// Atmosphere, eye, direction, sun, distance.
inline auto view(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const auto eye = draw.viewpoint(atmosphere);
    const auto direction = draw.view(atmosphere, eye);
    // Anywhere in the sky, straight up, straight down, along the view ray and against it.
    const int sun = draw.one_of({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4});
    const auto to_sun =
        sun == 0 ? draw.direction_at(eye.up, static_cast<double>(draw.cosine()))
                 : (sun == 1 ? eye.up : (sun == 2 ? -eye.up : (sun == 3 ? direction : -direction)));
    return std::make_tuple(atmosphere, eye, direction, to_sun, draw.distance(atmosphere));
}

/// Atmosphere, a ray that is in its air, eye, direction, sun.
inline auto ray_in_air(Draw& draw) {
    const auto [atmosphere, eye, direction, to_sun, distance] = view(draw);
    const auto air = airlight::air_ray(atmosphere, eye, direction, distance);
    const airlight::Viewpoint<float> on_ground{0.0F, eye.up};
    return air.in_air ? std::make_tuple(atmosphere, air, eye, direction, to_sun)
                      : std::make_tuple(
                            atmosphere,
                            airlight::air_ray(atmosphere, on_ground, eye.up, airlight::no_surface<float>()),
                            on_ground, eye.up, to_sun);
}

/// Atmosphere, a lit ray, a distance along it.
inline auto point_of_ray(Draw& draw) {
    const auto inputs = ray_in_air(draw);
    const auto ray = std::apply([](const auto&... x) { return airlight::lit_ray<float>(x...); }, inputs);
    return std::make_tuple(std::get<0>(inputs), ray, ray.air.extent * draw.number(0.01F, 1.0F));
}

}  // namespace parity
