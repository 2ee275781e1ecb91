#pragma once

// Random walks of light through the air of one colour, from the eye backwards.

#include <array>
#include <cstdint>

#include "air.hpp"
#include "estimate.hpp"

namespace reference {

/// What shines into the air.
struct Light {
    Vector to_sun{0, 0, 1};  ///< unit vector
    double sun_radius = 0;   ///< [rad] of the disc, which is evenly bright; 0 for a point
    double sun = 1;          ///< irradiance across the rays above the air; 1: results are per unit of it
    double sky = 0;          ///< radiance of space itself, from everywhere [1/sr]
};

/// Orders of scattering that are kept apart; the last holds all further ones. Light from the ground counts
/// as scattered once more.
inline constexpr int kept_orders = 12;

/// Radiance that the air adds to a view ray, without what lies behind it [1/sr].
struct Radiance {
    Estimate total;
    std::array<Estimate, kept_orders> order;  ///< [0] is light scattered once
};

/// A view ray: where its stretch in the air begins and how long it is.
struct ViewRay {
    Vector begin;       ///< [m] from the planet's centre
    Vector direction;   ///< unit vector
    double extent = 0;  ///< [m], 0 where it meets no air
    bool to_ground = false;
};

/// The stretch of a ray from `eye`, in metres from the planet's centre, that lies in the air.
ViewRay view_ray(const Air& air, const Vector& eye, const Vector& direction);

/// How much is traced.
struct Effort {
    std::uint64_t walks = 1000000;
    std::uint64_t seed = 1;
    int groups = 50;       ///< whose spread is the standard error; at least 2
    int orders = 1000000;  ///< of scattering that are followed
};

/// All orders of scattering. The first meeting with the air is always made, where light comes from, so that
/// thin air is not missed; from there on the walk is free by day. In twilight further steps are led towards
/// the glow, and a tenth of the walks are made.
Radiance traced(const Air& air, const Light& light, const ViewRay& ray, const Effort& effort);

/// Irradiance of level ground by the sky without the sun itself, per unit of the sun's, all orders.
Estimate sky_irradiance(const Air& air, const Light& light, const Effort& effort);

/// Share of a parallel beam, spread over the planet's disc, that the ground absorbs, followed forwards from
/// the sun.
Estimate absorbed_by_ground(const Air& air, const Effort& effort);

/// The same, followed backwards from the ground.
Estimate absorbed_by_ground_backwards(const Air& air, const Effort& effort);

}  // namespace reference
