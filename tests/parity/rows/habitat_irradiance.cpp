#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitat_irradiance.hpp>

#include "../habitats.hpp"

namespace parity {

static const bool strip_irradiance_in_air_row =
    row("strip_irradiance_in_air")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto position = place_in(draw, air);
            const auto normal = draw.direction();
            return std::make_tuple(air, light, position, normal, draw.one_of({0, 1, 1, 3}));
        })
        .cpu([](auto run, const auto& air, const auto& light, const auto& position, const auto& normal,
                int pieces) {
            using R = decltype(run);
            return airlight::strip_irradiance_in_air<typename R::T, typename R::Scene>(
                air, light, position, normal, pieces, run.light_visibility);
        })
        .within_bound();

static const bool habitat_irradiance_row =
    row("habitat_irradiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const auto position = place_in(draw, air);
            const auto normal = draw.direction();
            return std::make_tuple(air, lights, position, normal, draw.one_of({0, 1, 2}));
        })
        .count(2048)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& position, const auto& normal,
                int pieces) {
            using R = decltype(run);
            return airlight::habitat_irradiance<typename R::T, typename R::Scene>(
                air, lights, position, normal, pieces, run.light_visibility);
        })
        .within_bound();

}  // namespace parity
