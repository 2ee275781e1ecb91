#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitat_scattering.hpp>

#include "../habitats.hpp"

namespace parity {

static auto habitat_view(Draw& draw) {
    const auto air = habitat(draw);
    const auto lights = lights_in(draw, air);
    return std::tuple_cat(std::make_tuple(air, lights), ray_in(draw, air));
}

static const bool habitat_mean_radiance_row =
    row("habitat_mean_radiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const auto position = place_in(draw, air);
            return std::make_tuple(air, lights, position, draw.one_of({0, 1, 2}));
        })
        .count(2048)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& position, int pieces) {
            using R = decltype(run);
            return airlight::habitat_mean_radiance<typename R::T, typename R::Scene>(
                air, lights, position, pieces, run.light_visibility);
        })
        .within_bound();

static const bool habitat_bare_radiance_row =
    row("habitat_bare_radiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            return std::make_tuple(air, lights, place_in(draw, air));
        })
        .cpu([](const auto& air, const auto& lights, const auto& position) {
            return airlight::habitat_bare_radiance(air, lights, position);
        })
        .to_the_bit();

static const bool habitat_mean_passed_row =
    row("habitat_mean_passed")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const auto position = place_in(draw, air);
            return std::make_tuple(air, lights, position, draw.one_of({0, 1, 2}));
        })
        .count(2048)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& position, int pieces) {
            using R = decltype(run);
            return airlight::habitat_mean_passed<typename R::T, typename R::Scene>(
                air, lights, position, pieces, run.light_visibility);
        })
        .within_bound();

static const bool habitat_scattering_marched_row =
    row("habitat_scattering_marched")
        .inputs([](Draw& draw) {
            return std::tuple_cat(habitat_view(draw), std::make_tuple(draw.one_of({0, 1, 4})));
        })
        .count(4096)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& eye, const auto& direction,
                auto distance, int steps) {
            using R = decltype(run);
            return airlight::habitat_scattering_marched<typename R::T, typename R::Scene>(
                air, lights, eye, direction, distance, steps, run.habitat_light);
        })
        .within_bound();

static const bool habitat_scattering_by_nodes_row =
    row("habitat_scattering_by_nodes")
        .inputs(habitat_view)
        .count(2048)
        .left_out(0.35, 0.01, nearest_strip)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& eye, const auto& direction,
                auto distance) {
            using R = decltype(run);
            return airlight::habitat_scattering_by_nodes<typename R::T, typename R::Scene>(
                air, lights, eye, direction, distance, run.habitat_light);
        })
        .within_bound();

}  // namespace parity
