#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/gathered_light.hpp>

namespace parity {

static const char* const grazing =
    "rays that graze the top of the air exactly, and suns exactly behind or across the ray, are end points "
    "where "
    "rounding decides how long the ray or its shadow is";

static const bool incoming_light_row =
    row("incoming_light")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const airlight::vec3<float> up(0.0F, 0.0F, 1.0F);
            return std::make_tuple(atmosphere, draw.altitude_in_air(atmosphere),
                                   draw.direction_at(up, static_cast<double>(draw.cosine())),
                                   draw.direction_at(up, static_cast<double>(draw.cosine())),
                                   draw.one_of({0, 1}) == 1);
        })
        .count(2048)
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, auto altitude, const auto& direction, const auto& to_sun,
                bool first_order) {
            using R = decltype(run);
            return airlight::incoming_light<typename R::T, typename R::Scene>(
                atmosphere, altitude, direction, to_sun, first_order, run.multiple_scattering,
                run.ground_irradiance, run.visibility);
        })
        .within_bound();

// A sum over hundreds of rays, each of which is compared above.
static const bool gathered_light_row =
    row("gathered_light")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            // Of hundreds of rays of the first order there is always one whose shadow ends where the error of
            // exp decides; incoming_light has that order's rays one by one.
            return std::make_tuple(atmosphere, 0.5F * draw.altitude_in_air(atmosphere), draw.cosine(), false);
        })
        .count(16)
        .left_out(0.9, 0.5, "one of hundreds of rays may end where rounding decides")
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s, bool first_order) {
            using R = decltype(run);
            return airlight::gathered_light<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu_s, first_order, run.multiple_scattering, run.ground_irradiance,
                run.visibility);
        })
        .within_bound();

}  // namespace parity
