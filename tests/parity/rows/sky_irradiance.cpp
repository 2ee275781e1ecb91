#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/sky_irradiance.hpp>

namespace parity {

static const bool sky_irradiance_on_row =
    row("sky_irradiance_on")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.sky_irradiance(), draw.cosine(), draw.cosine(), draw.cosine());
        })
        .cpu([](const auto& sky, auto mu_normal, auto mu_s, auto cos_incidence) {
            return airlight::sky_irradiance_on(sky, mu_normal, mu_s, cos_incidence);
        })
        .to_the_bit();

}  // namespace parity
