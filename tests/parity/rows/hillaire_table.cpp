#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/hillaire_table.hpp>

#include "table_inputs.hpp"

namespace parity {

static const bool cosine_of_half_turn_row =
    row("cosine_of_half_turn")
        .inputs([](Draw& draw) { return std::make_tuple(draw.number(0.0F, 1.0F, {0.5F})); })
        .cpu([](auto share) { return airlight::cosine_of_half_turn(share); })
        .to_the_bit();

static const bool sunlight_at_row =
    row("sunlight_at")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = height_in_air(draw, atmosphere);
            const float radius = atmosphere.ground_radius + altitude;
            const float sun_height = radius * draw.grazing_cosine(atmosphere.ground_radius, altitude);
            return std::make_tuple(atmosphere, airlight::layers_of(atmosphere), altitude, sun_height);
        })
        .cpu([](auto run, const auto& atmosphere, const auto& layers, auto altitude, auto sun_height) {
            using R = decltype(run);
            return airlight::sunlight_at<typename R::T, typename R::Scene>(atmosphere, layers, altitude,
                                                                           sun_height);
        })
        .within_bound();

static const bool gathered_along_row =
    row("gathered_along")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const airlight::Viewpoint<float> eye{height_in_air(draw, atmosphere),
                                                 airlight::vec3<float>(0.0F, 0.0F, 1.0F)};
            const auto direction = draw.view(atmosphere, eye);
            const auto to_sun = draw.direction_at(eye.up, static_cast<double>(draw.cosine()));
            return std::make_tuple(atmosphere, airlight::layers_of(atmosphere), eye, direction, to_sun,
                                   draw.one_of({0, 1, 5, 20}));
        })
        .count(4096)
        .cpu([](auto run, const auto& atmosphere, const auto& layers, const auto& eye, const auto& direction,
                const auto& to_sun, int steps) {
            using R = decltype(run);
            return airlight::gathered_along<typename R::T, typename R::Scene>(atmosphere, layers, eye,
                                                                              direction, to_sun, steps);
        })
        .within_bound();

static const bool hillaire_texel_row =
    row("hillaire_texel")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            // Not the ground or the top, where every horizontal ray may be in the air or not: gathered_along
            // has those.
            const float altitude = draw.number(0.01F, 0.9F) * atmosphere.top_altitude;
            const float mu_s = draw.number(-0.3F, 1.0F);
            const int zeniths = draw.one_of({2, 4});
            const int azimuths = draw.one_of({1, 2});
            return std::make_tuple(atmosphere, altitude, mu_s, zeniths, azimuths, draw.one_of({1, 4}));
        })
        .count(2048)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s, int zeniths, int azimuths,
                int steps) {
            using R = decltype(run);
            return airlight::hillaire_texel<typename R::T, typename R::Scene>(atmosphere, altitude, mu_s,
                                                                              zeniths, azimuths, steps);
        })
        .within_bound();

}  // namespace parity
