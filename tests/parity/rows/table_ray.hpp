#pragma once

// The rays that tables of scattered light know, and what stands in for the tables.

#include <airlight/scattering_orders.hpp>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "row.hpp"

namespace parity {

/// Atmosphere, altitude, mu, mu_s, nu, whether the ray ends on the ground.
inline auto table_ray(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float altitude = draw.altitude_in_air(atmosphere);
    const float mu = draw.grazing_cosine(atmosphere.ground_radius, altitude);
    const float mu_s = draw.cosine();
    const float sines = std::sqrt(std::max((1.0F - mu * mu) * (1.0F - mu_s * mu_s), 0.0F));
    const float nu = glm::clamp(mu * mu_s + sines * draw.number(-1.0F, 1.0F), -1.0F, 1.0F);
    return std::make_tuple(atmosphere, altitude, mu, mu_s, nu,
                           airlight::behind_planet(atmosphere.ground_radius, altitude, mu));
}

/// The stand-in for a table where the run has hooks, else what the function has by default.
template <typename Default, typename StandIn, typename Run>
auto hook_of(const Run& run) {
    constexpr bool hooked = std::is_same_v<std::decay_t<decltype(run.visibility)>, PartlyLit>;
    return std::conditional_t<hooked, StandIn, Default>{};
}

/// Why some of a ray's inputs are left out.
inline const char* const table_rays_left_out =
    "rays that graze the top of the air or the ground exactly, and suns exactly behind or across the ray, "
    "are "
    "end points where rounding decides how long the ray or its shadow is";

}  // namespace parity
