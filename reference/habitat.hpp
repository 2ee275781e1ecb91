#pragma once

// Random walks of light through the air of a habitat and between its walls, from the eye backwards, one
// colour at a time. Needs the headers of the library and nothing else.

#include <airlight/habitats.hpp>
#include <cstdint>

#include "directions.hpp"
#include "estimate.hpp"

namespace reference {

/// A habitat with smooth walls and caps that reflect by Lambert's law. The strips are rectangles on the
/// wall's tangent that shine from their inner side; what they cover is wall all the same, it reflects
/// besides.
struct Habitat {
    airlight::HabitatAir<double> air;
    airlight::HabitatLights<double> lights;
    Vector albedo{0.3, 0.3, 0.3};  ///< of walls and caps, a spectrum
    bool isotropic = false;        ///< the air scatters evenly to all sides, not by its phase functions
};

/// Meetings with air, walls and caps after which a path goes on until chance ends it.
inline constexpr int every_order = 1000000;

/// Radiance that the air before a surface adds to a view ray, without the surface's own: light that meets
/// this air last. With `orders` 1 light straight from the strips, scattered once; with more, light that met
/// as many places, wall or air.
Estimate habitat_air_light(const Habitat& habitat, int channel, const Vector& eye, const Vector& direction,
                           double distance, int orders, std::uint64_t walks, std::uint64_t seed);

/// Irradiance of a surface: straight from the strips, and by way of up to `bounces` places, wall or air.
Estimate habitat_surface_irradiance(const Habitat& habitat, int channel, const Vector& position,
                                    const Vector& normal, int bounces, std::uint64_t walks,
                                    std::uint64_t seed);

/// Radiance of a pixel, a spectrum: of a surface at `distance` by Lambert's law, which is no part of the
/// smooth wall and has its own normal and albedo, plus its `emission`, past the air; and of the air before
/// it. With `orders` 1 the surface's light comes straight from the strips and the air's is scattered once.
/// `walks` each for the surface and for the air, in each colour.
Vector habitat_pixel(const Habitat& habitat, const Vector& eye, const Vector& direction, double distance,
                     const Vector& normal, const Vector& albedo, const Vector& emission, int orders,
                     std::uint64_t walks, std::uint64_t seed);

}  // namespace reference
