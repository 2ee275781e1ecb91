#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/table_mapping.hpp>

#include "table_inputs.hpp"

namespace parity {

static const bool share_of_row =
    row("share_of")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.number(-2.0F, 4.0F, {0.0F, 1.0F}),
                                   draw.number(-1.0F, 3.0F, {0.0F, 1.0F}));
        })
        .cpu([](auto part, auto whole) { return airlight::share_of(part, whole); })
        .to_the_bit();

static const bool texture_from_unit_row =
    row("texture_from_unit")
        .inputs([](Draw& draw) { return std::make_tuple(coordinate(draw), table_size(draw)); })
        .cpu([](auto x, int size) { return airlight::texture_from_unit(x, size); })
        .to_the_bit();

static const bool unit_from_texture_row =
    row("unit_from_texture")
        .inputs([](Draw& draw) { return std::make_tuple(coordinate(draw), table_size(draw)); })
        .cpu([](auto u, int size) { return airlight::unit_from_texture(u, size); })
        .to_the_bit();

static const bool table_altitude_row = row("table_altitude")
                                           .inputs([](Draw& draw) {
                                               const auto atmosphere = draw.atmosphere();
                                               return std::make_tuple(atmosphere, draw.altitude(atmosphere));
                                           })
                                           .cpu([](const auto& atmosphere, auto altitude) {
                                               return airlight::table_altitude(atmosphere, altitude);
                                           })
                                           .to_the_bit();

static const bool table_cosine_row =
    row("table_cosine")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.number(-1.5F, 1.5F, {-1.0F, 0.0F, 1.0F}));
        })
        .cpu([](auto mu) { return airlight::table_cosine(mu); })
        .to_the_bit();

static auto radius_and_altitude(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    return std::make_tuple(atmosphere.ground_radius, height_in_air(draw, atmosphere));
}

static const bool horizon_distance_row =
    row("horizon_distance")
        .inputs(radius_and_altitude)
        .cpu([](auto radius, auto altitude) { return airlight::horizon_distance(radius, altitude); })
        .to_the_bit();

static const bool altitude_of_horizon_row =
    row("altitude_of_horizon")
        .inputs(radius_and_altitude)
        .cpu([](auto radius, auto distance) { return airlight::altitude_of_horizon(radius, distance); })
        .to_the_bit();

static const bool horizon_cosine_row =
    row("horizon_cosine")
        .inputs(radius_and_altitude)
        .cpu([](auto radius, auto altitude) { return airlight::horizon_cosine(radius, altitude); })
        .to_the_bit();

static const bool excess_to_top_row =
    row("excess_to_top")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = height_in_air(draw, atmosphere);
            return std::make_tuple(atmosphere.ground_radius, atmosphere.top_altitude, altitude,
                                   draw.cosine());
        })
        .cpu([](auto radius, auto top, auto altitude, auto mu) {
            return airlight::excess_to_top(radius, top, altitude, mu);
        })
        .to_the_bit();

static const bool cosine_from_excess_row =
    row("cosine_from_excess")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = height_in_air(draw, atmosphere);
            const float excess = draw.magnitude(1e-6F, 2.0F, {0.0F}) * atmosphere.ground_radius;
            return std::make_tuple(atmosphere.ground_radius, atmosphere.top_altitude, altitude, excess);
        })
        .cpu([](auto radius, auto top, auto altitude, auto excess) {
            return airlight::cosine_from_excess(radius, top, altitude, excess);
        })
        .to_the_bit();

static const bool unit_from_altitude_row =
    row("unit_from_altitude")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.altitude(atmosphere));
        })
        .cpu([](const auto& atmosphere, auto altitude) {
            return airlight::unit_from_altitude(atmosphere, altitude);
        })
        .to_the_bit();

static const bool altitude_from_unit_row =
    row("altitude_from_unit")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere(), draw.number(0.0F, 1.0F)); })
        .cpu([](const auto& atmosphere, auto x) { return airlight::altitude_from_unit(atmosphere, x); })
        .to_the_bit();

static const bool unit_from_upward_cosine_row =
    row("unit_from_upward_cosine")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, height_in_air(draw, atmosphere), draw.cosine());
        })
        .cpu([](const auto& atmosphere, auto altitude, auto mu) {
            return airlight::unit_from_upward_cosine(atmosphere, altitude, mu);
        })
        .to_the_bit();

static const bool upward_cosine_from_unit_row =
    row("upward_cosine_from_unit")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, height_in_air(draw, atmosphere), draw.number(0.0F, 1.0F));
        })
        .cpu([](const auto& atmosphere, auto altitude, auto x) {
            return airlight::upward_cosine_from_unit(atmosphere, altitude, x);
        })
        .to_the_bit();

static auto place(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    return std::make_tuple(atmosphere, draw.altitude(atmosphere), draw.cosine(), table_size(draw),
                           table_size(draw));
}
static auto texel(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float u = coordinate(draw);
    return std::make_tuple(atmosphere, airlight::vec2<float>(u, coordinate(draw)), table_size(draw),
                           table_size(draw));
}

static const bool extinction_uv_row =
    row("extinction_uv")
        .inputs(place)
        .cpu([](const auto& atmosphere, auto altitude, auto mu, int width, int height) {
            return airlight::extinction_uv(atmosphere, altitude, mu, width, height);
        })
        .to_the_bit();

static const bool extinction_parameters_row =
    row("extinction_parameters")
        .inputs(texel)
        .cpu([](const auto& atmosphere, const auto& uv, int width, int height) {
            return airlight::extinction_parameters(atmosphere, uv, width, height);
        })
        .to_the_bit();

static const bool transmittance_uv_row =
    row("transmittance_uv")
        .inputs(place)
        .cpu([](const auto& atmosphere, auto altitude, auto mu, int width, int height) {
            return airlight::transmittance_uv(atmosphere, altitude, mu, width, height);
        })
        .to_the_bit();

static const bool transmittance_parameters_row =
    row("transmittance_parameters")
        .inputs(texel)
        .cpu([](const auto& atmosphere, const auto& uv, int width, int height) {
            return airlight::transmittance_parameters(atmosphere, uv, width, height);
        })
        .to_the_bit();

static const bool altitude_sun_uv_row =
    row("altitude_sun_uv")
        .inputs(place)
        .cpu([](const auto& atmosphere, auto altitude, auto mu_s, int width, int height) {
            return airlight::altitude_sun_uv(atmosphere, altitude, mu_s, width, height);
        })
        .to_the_bit();

static const bool altitude_sun_parameters_row =
    row("altitude_sun_parameters")
        .inputs(texel)
        .cpu([](const auto& atmosphere, const auto& uv, int width, int height) {
            return airlight::altitude_sun_parameters(atmosphere, uv, width, height);
        })
        .to_the_bit();

static const bool texture_from_halves_row =
    row("texture_from_halves")
        .inputs([](Draw& draw) {
            const float x = draw.number(0.0F, 1.0F);
            return std::make_tuple(x, draw.one_of({0, 1}) == 1, even_size(draw));
        })
        .cpu([](auto x, bool upper, int size) { return airlight::texture_from_halves(x, upper, size); })
        .to_the_bit();

static const bool unit_from_halves_row =
    row("unit_from_halves")
        .inputs([](Draw& draw) { return std::make_tuple(coordinate(draw), even_size(draw)); })
        .cpu([](auto u, int size) { return airlight::unit_from_halves(u, size); })
        .to_the_bit();

static const bool bent_sun_row =
    row("bent_sun")
        .inputs([](Draw& draw) {
            const float mu_s = draw.cosine();
            return std::make_tuple(mu_s, draw.number(0.05F, 1.0F, {0.15F, 0.225F}));
        })
        .cpu([](auto mu_s, auto bend) { return airlight::bent_sun(mu_s, bend); })
        .to_the_bit();

static const bool sun_from_bent_row =
    row("sun_from_bent")
        .inputs([](Draw& draw) {
            const float bent = draw.cosine();
            return std::make_tuple(bent, draw.number(0.05F, 1.0F, {0.15F, 0.225F}));
        })
        .cpu([](auto bent, auto bend) { return airlight::sun_from_bent(bent, bend); })
        .to_the_bit();

static const bool cosines_below_horizon_row =
    row("cosines_below_horizon")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = height_in_air(draw, atmosphere);
            return std::make_tuple(atmosphere.ground_radius, altitude,
                                   airlight::horizon_cosine(atmosphere.ground_radius, altitude));
        })
        .cpu([](auto radius, auto altitude, auto horizon) {
            return airlight::cosines_below_horizon(radius, altitude, horizon);
        })
        .to_the_bit();

static const bool sun_over_x_row = row("sun_over_x")
                                       .inputs([](Draw& draw) { return std::make_tuple(draw.cosine()); })
                                       .cpu([](auto mu_s) { return airlight::sun_over_x(mu_s); })
                                       .to_the_bit();

}  // namespace parity
