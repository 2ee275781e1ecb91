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

static const bool bent_normal_row =
    row("bent_normal")
        .inputs([](Draw& draw) {
            const auto normal = draw.direction();
            const float bend = draw.number(0.0F, 1.0F, {0.5F, 0.6F});
            const auto to_sun = draw.one_of({0, 0, 0, 1}) == 0 ? draw.direction() : -normal;
            return std::make_tuple(normal, to_sun, bend);
        })
        .cpu([](const auto& normal, const auto& to_sun, auto bend) {
            return airlight::bent_normal(normal, to_sun, bend);
        })
        .to_the_bit();

}  // namespace parity
