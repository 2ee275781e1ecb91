#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/density.hpp>

namespace parity {

// Below the ground, on it, in the air, far above it; metres or kilometres.
static float altitude(Draw& draw) {
    return draw.magnitude(1e-3F, 1e6F, {0.0F, -1.0F, -1e5F, 25e3F, 1e9F});
}

static const bool exponential_density_row =
    row("exponential_density")
        .inputs([](Draw& draw) {
            return std::make_tuple(altitude(draw), draw.magnitude(1.0F, 2e4F, {0.0F, 8e3F}));
        })
        .cpu([](auto h, auto scale_height) { return airlight::exponential_density(h, scale_height); })
        .within_bound();

static const bool tent_density_row =
    row("tent_density")
        .inputs([](Draw& draw) {
            return std::make_tuple(altitude(draw), draw.magnitude(1.0F, 1e5F, {0.0F, 25e3F}),
                                   draw.magnitude(1.0F, 1e5F, {0.0F, 15e3F}));
        })
        .cpu([](auto h, auto centre, auto half_width) {
            return airlight::tent_density(h, centre, half_width);
        })
        .to_the_bit();

static const bool lorentzian_density_row =
    row("lorentzian_density")
        .inputs([](Draw& draw) {
            return std::make_tuple(altitude(draw), draw.magnitude(1.0F, 1e5F, {0.0F, 30e3F}),
                                   draw.magnitude(1.0F, 1e5F, {0.0F, 4e3F}));
        })
        .cpu([](auto h, auto centre, auto half_width) {
            return airlight::lorentzian_density(h, centre, half_width);
        })
        .to_the_bit();

}  // namespace parity
