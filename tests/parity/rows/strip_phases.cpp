#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/strip_phases.hpp>

#include "../habitats.hpp"

namespace parity {

static const bool draine_excess_row =
    row("draine_excess")
        .inputs([](Draw& draw) {
            const float g = draw.number(0.0F, 0.999F, {0.0F, 0.8F, 1e-6F});
            return std::make_tuple(draw.cosine(), g, draw.number(0.0F, 30.0F, {0.0F, 1.0F}));
        })
        .cpu([](auto cos_theta, auto g, auto alpha) { return airlight::draine_excess(cos_theta, g, alpha); })
        .to_the_bit();

static const bool draine_phase_edge_row =
    row("draine_phase_edge")
        .inputs([](Draw& draw) {
            const auto begin = draw.direction();
            const auto end = draw.direction();
            const auto direction = draw.direction();
            const float g = draw.number(-0.95F, 0.95F, {0.0F, 0.8F, 1e-6F});
            return std::make_tuple(begin, end, direction, g, draw.number(0.0F, 30.0F, {0.0F, 1.0F}));
        })
        .cpu([](const auto& begin, const auto& end, const auto& direction, auto g, auto alpha) {
            return airlight::draine_phase_edge(begin, end, direction, g, alpha);
        })
        .left_out(0.25, 0.03, "a sharp lobe along an end of the edge; measured: 0.016 in WebGL")
        .to_the_bit();

static const bool rayleigh_phase_edge_row =
    row("rayleigh_phase_edge")
        .inputs([](Draw& draw) {
            const auto begin = draw.direction();
            const auto end = draw.direction();
            return std::make_tuple(begin, end, draw.direction());
        })
        .cpu([](const auto& begin, const auto& end, const auto& direction) {
            return airlight::rayleigh_phase_edge(begin, end, direction);
        })
        .to_the_bit();

static const bool strip_phases_row =
    row("strip_phases")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto [light, position] = strip_and_place_near_it(draw, air);
            const float solid_angle = glm::max(airlight::strip_view(light, position).solid_angle, 1e-3F);
            return std::make_tuple(light, position, draw.direction(), solid_angle, air.mie_g);
        })
        .cpu([](auto run, const auto& light, const auto& position, const auto& direction, auto solid_angle,
                auto mie_g) {
            using R = decltype(run);
            return airlight::strip_phases<typename R::T, typename R::Scene>(light, position, direction,
                                                                            solid_angle, mie_g);
        })
        .within_bound();

}  // namespace parity
