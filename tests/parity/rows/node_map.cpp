#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/node_map.hpp>

namespace parity {

static const bool node_fit_row = row("node_fit")
                                     .no_inputs()
                                     .cpu([](auto run) {
                                         using R = decltype(run);
                                         return airlight::node_fit<typename R::T, typename R::Scene>();
                                     })
                                     .to_the_bit();

static auto piece(Draw& draw) {
    const airlight::NodeFit<float> fit = airlight::node_fit<float>();
    const float radius = draw.magnitude(1e3F, 1e8F, {6.36e6F});
    const float along = radius * draw.magnitude(1e-6F, 1.0F, {0.0F});
    const float rise = draw.magnitude(1e-6F, 1e6F);
    const float height = draw.magnitude(0.1F, 1e6F, {8e3F});
    const float pulled = draw.magnitude(1e-3F, 1e4F, {0.0F}) * (draw.one_of({0, 1}) == 0 ? 1.0F : -1.0F);
    return std::make_tuple(fit, radius, along, radius + rise, rise, height, pulled);
}

static const bool node_map_row =
    row("node_map")
        .inputs(piece)
        .cpu([](const auto& fit, auto low_radius, auto low_along, auto high_radius, auto rise, auto height,
                auto pulled) {
            return airlight::node_map(fit, low_radius, low_along, high_radius, rise, height, pulled);
        })
        .to_the_bit();

static const bool node_at_row =
    row("node_at")
        .inputs([](Draw& draw) {
            const auto map =
                std::apply([](const auto&... x) { return airlight::node_map(x...); }, piece(draw));
            return std::make_tuple(map, draw.number(0.002F, 0.998F));
        })
        .cpu([](const auto& map, auto u) { return airlight::node_at(map, u); })
        .to_the_bit();

}  // namespace parity
