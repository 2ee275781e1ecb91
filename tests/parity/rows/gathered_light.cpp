#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/gathered_light.hpp>

#include "../views.hpp"

namespace parity {

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
        .hooked_everywhere()  // without them the orders after the first are 0
        .count(2048)
        .left_out(0.35, 0.2, grazing)
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
            const bool first_order = !draw.planet_shadow() && draw.one_of({0, 1}) == 1;
            return std::make_tuple(atmosphere, 0.5F * draw.altitude_in_air(atmosphere), draw.cosine(),
                                   first_order);
        })
        .hooked_everywhere()
        .count(32)
        .left_out(0.9, 0.5, "one of hundreds of rays may end where rounding decides")
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s, bool first_order) {
            using R = decltype(run);
            return airlight::gathered_light<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu_s, first_order, run.multiple_scattering, run.ground_irradiance,
                run.visibility);
        })
        .within_bound();

static airlight::GatheredLight<float> some_light(Draw& draw) {
    const auto drawn = [&] { return draw.spectrum(1e-6F, 10.0F); };
    const airlight::DiffuseLight<float> light{drawn(), drawn(), drawn(), drawn(), drawn(),
                                              drawn(), drawn(), drawn(), drawn()};
    return {light, {drawn(), drawn(), drawn()}};
}

static const bool sum_of_light_row = row("sum_of_light")
                                         .inputs([](Draw& draw) {
                                             const auto a = some_light(draw);
                                             const auto share = draw.spectrum(0.1F, 20.0F);
                                             return std::make_tuple(a, share, some_light(draw));
                                         })
                                         .cpu([](const auto& a, const auto& share, const auto& b) {
                                             return airlight::sum_of_light(a, share, b);
                                         })
                                         .to_the_bit();

static const bool gain_of_last_order_row =
    row("gain_of_last_order")
        .inputs([](Draw& draw) {
            const float before = draw.magnitude(1e-9F, 1.0F, {0.0F});
            return std::make_tuple(before, draw.number(0.0F, 1.5F, {0.95F, 1.0F}) * before);
        })
        .cpu([](auto before, auto last) { return airlight::gain_of_last_order(before, last); })
        .to_the_bit();

}  // namespace parity
