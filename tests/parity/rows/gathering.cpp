#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/gathering.hpp>

namespace parity {

static const bool sphere_direction_row =
    row("sphere_direction")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = glm::max(draw.altitude_in_air(atmosphere), 0.0F);
            const int side = draw.one_of({0, 1});
            const int polar = draw.one_of({0, 1, 2});  // three nodes are the fewest of any scene
            const int azimuth = draw.one_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
            return std::make_tuple(atmosphere.ground_radius, altitude, side, polar, azimuth);
        })
        .cpu([](auto run, auto ground_radius, auto altitude, int side, int polar, int azimuth) {
            using R = decltype(run);
            return airlight::sphere_direction<typename R::T, typename R::Scene>(ground_radius, altitude, side,
                                                                                polar, azimuth);
        })
        .to_the_bit();

static const bool direct_irradiance_row =
    row("direct_irradiance")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            return std::make_tuple(atmosphere, altitude,
                                   draw.grazing_cosine(atmosphere.ground_radius, altitude));
        })
        .left_out(
            0.35, 0.1,
            "rays that graze the top of the air or the ground exactly are end points where rounding decides")
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s) {
            using R = decltype(run);
            return airlight::direct_irradiance<typename R::T, typename R::Scene>(atmosphere, altitude, mu_s);
        })
        .within_bound();

}  // namespace parity
