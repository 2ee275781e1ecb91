#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/ray_legs.hpp>

#include "../views.hpp"

namespace parity {

static const bool ray_legs_row =
    row("ray_legs")
        .inputs([](Draw& draw) {
            const auto [atmosphere, ray, t] = point_of_ray(draw);
            return std::make_tuple(atmosphere, ray);
        })
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& ray) {
            using R = decltype(run);
            return airlight::ray_legs<typename R::T, typename R::Scene>(atmosphere, ray);
        })
        .within_bound();

/// Atmosphere, ray and legs.
static auto legs(Draw& draw) {
    const auto [atmosphere, ray, t] = point_of_ray(draw);
    return std::make_tuple(atmosphere, ray, airlight::ray_legs<float>(atmosphere, ray));
}

static const bool leg_offset_row =
    row("leg_offset")
        .inputs([](Draw& draw) {
            airlight::RayLegs<float> legs{};
            legs.start.outwards = draw.column();
            legs.turned.outwards = draw.column();
            return std::make_tuple(legs, draw.one_of({0, 1}) == 1);
        })
        .cpu([](const auto& legs, bool climbs) { return airlight::leg_offset(legs, climbs); })
        .to_the_bit();

static const bool depth_of_legs_row =
    row("depth_of_legs")
        .inputs([](Draw& draw) {
            const auto [atmosphere, ray, its_legs] = legs(draw);
            return std::make_tuple(atmosphere, its_legs);
        })
        .cpu([](auto run, const auto& atmosphere, const auto& legs) {
            using R = decltype(run);
            return airlight::depth_of_legs<typename R::T, typename R::Scene>(atmosphere, legs);
        })
        .within_bound();

static const bool loss_ratio_row =
    row("loss_ratio")
        .inputs([](Draw& draw) {
            const float found = draw.magnitude(1e-6F, 3.0F, {0.0F});
            const float swept = draw.magnitude(1e-6F, 1e3F, {0.0F});
            return std::make_tuple(found, swept, draw.magnitude(1e-6F, 1e3F, {0.0F}));
        })
        .cpu([](auto found, auto swept, auto depth) { return airlight::loss_ratio(found, swept, depth); })
        .within_bound();

static const bool loss_ratios_row = row("loss_ratios")
                                        .inputs([](Draw& draw) {
                                            const auto found = draw.spectrum(1e-6F, 3.0F);
                                            const auto swept = draw.spectrum(1e-6F, 1e3F);
                                            return std::make_tuple(found, swept, draw.spectrum(1e-6F, 1e3F));
                                        })
                                        .cpu([](const auto& found, const auto& swept, const auto& depth) {
                                            return airlight::loss_ratios(found, swept, depth);
                                        })
                                        .within_bound();

static const bool leg_map_row =
    row("leg_map")
        .inputs([](Draw& draw) {
            return std::tuple_cat(legs(draw), std::make_tuple(draw.one_of({0, 1}) == 1));
        })
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& ray, const auto& legs, bool climbs) {
            using R = decltype(run);
            return airlight::leg_map<typename R::T, typename R::Scene>(atmosphere, ray, legs, climbs);
        })
        .within_bound();

}  // namespace parity
