#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/scattering_mapping.hpp>

#include "table_inputs.hpp"

namespace parity {

/// A lowest sun: that of a thin atmosphere, of a thick one, or any.
static float lowest_sun(Draw& draw) {
    return draw.number(-1.0F, -0.05F, {-0.2F, -0.35F});
}

static const bool lowest_sun_cosine_row =
    row("lowest_sun_cosine")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](const auto& atmosphere) { return airlight::lowest_sun_cosine(atmosphere); })
        .to_the_bit();

static auto texel(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float u = coordinate(draw);
    const float v = coordinate(draw);
    return std::make_tuple(atmosphere, airlight::vec3<float>(u, v, coordinate(draw)));
}

static const bool linear_inscatter_uvw_row =
    row("linear_inscatter_uvw")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            const float mu = draw.cosine();
            return std::make_tuple(atmosphere, altitude, mu, draw.cosine(), table_size(draw),
                                   table_size(draw), table_size(draw));
        })
        .cpu([](const auto& atmosphere, auto altitude, auto mu, auto mu_s, int width, int height, int depth) {
            return airlight::linear_inscatter_uvw(atmosphere, altitude, mu, mu_s, width, height, depth);
        })
        .to_the_bit();

static const bool linear_inscatter_parameters_row =
    row("linear_inscatter_parameters")
        .inputs([](Draw& draw) {
            return std::tuple_cat(texel(draw),
                                  std::make_tuple(table_size(draw), table_size(draw), table_size(draw)));
        })
        .cpu([](const auto& atmosphere, const auto& uvw, int width, int height, int depth) {
            return airlight::linear_inscatter_parameters(atmosphere, uvw, width, height, depth);
        })
        .to_the_bit();

static const bool inscatter_uvw_row =
    row("inscatter_uvw")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            const float mu = draw.cosine();
            const float mu_s = draw.cosine();
            const bool ground = draw.one_of({0, 1}) == 1;
            return std::make_tuple(atmosphere, altitude, mu, mu_s, ground, lowest_sun(draw), table_size(draw),
                                   even_size(draw), table_size(draw));
        })
        .cpu([](const auto& atmosphere, auto altitude, auto mu, auto mu_s, bool ground, auto lowest,
                int width, int height, int depth) {
            return airlight::inscatter_uvw(atmosphere, altitude, mu, mu_s, ground, lowest, width, height,
                                           depth);
        })
        .within_bound();

static const bool inscatter_parameters_row =
    row("inscatter_parameters")
        .inputs([](Draw& draw) {
            return std::tuple_cat(texel(draw), std::make_tuple(lowest_sun(draw), table_size(draw),
                                                               even_size(draw), table_size(draw)));
        })
        .cpu([](const auto& atmosphere, const auto& uvw, auto lowest, int width, int height, int depth) {
            return airlight::inscatter_parameters(atmosphere, uvw, lowest, width, height, depth);
        })
        .to_the_bit();

static const bool excess_to_ground_row =
    row("excess_to_ground")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = height_in_air(draw, atmosphere);
            const float mu = draw.grazing_cosine(atmosphere.ground_radius, altitude);
            return std::make_tuple(atmosphere.ground_radius, altitude, mu < 0.0F ? mu : -mu);
        })
        .cpu([](auto radius, auto altitude, auto mu) {
            return airlight::excess_to_ground(radius, altitude, mu);
        })
        .to_the_bit();

static const bool excess_to_horizon_row =
    row("excess_to_horizon")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere.ground_radius, height_in_air(draw, atmosphere));
        })
        .cpu([](auto radius, auto altitude) { return airlight::excess_to_horizon(radius, altitude); })
        .to_the_bit();

static const bool unit_from_sun_row =
    row("unit_from_sun")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.cosine(), lowest_sun(draw));
        })
        .cpu([](const auto& atmosphere, auto mu_s, auto lowest) {
            return airlight::unit_from_sun(atmosphere, mu_s, lowest);
        })
        .to_the_bit();

static const bool sun_from_unit_row =
    row("sun_from_unit")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.number(0.0F, 1.0F), lowest_sun(draw));
        })
        .cpu([](const auto& atmosphere, auto x, auto lowest) {
            return airlight::sun_from_unit(atmosphere, x, lowest);
        })
        .to_the_bit();

static const bool possible_nu_row =
    row("possible_nu")
        .inputs([](Draw& draw) {
            const float mu = draw.cosine();
            const float mu_s = draw.cosine();
            return std::make_tuple(mu, mu_s, draw.cosine());
        })
        .cpu([](auto mu, auto mu_s, auto nu) { return airlight::possible_nu(mu, mu_s, nu); })
        .to_the_bit();

static const bool scattering_lookup_row =
    row("scattering_lookup")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            const float mu = draw.cosine();
            const float mu_s = draw.cosine();
            const float nu = draw.cosine();
            const bool ground = draw.one_of({0, 1}) == 1;
            return std::make_tuple(atmosphere, altitude, mu, mu_s, nu, ground, lowest_sun(draw),
                                   table_size(draw), table_size(draw), even_size(draw), table_size(draw));
        })
        .cpu([](const auto& atmosphere, auto altitude, auto mu, auto mu_s, auto nu, bool ground, auto lowest,
                int nu_size, int mu_s_size, int mu_size, int altitude_size) {
            return airlight::scattering_lookup(atmosphere, altitude, mu, mu_s, nu, ground, lowest, nu_size,
                                               mu_s_size, mu_size, altitude_size);
        })
        .to_the_bit();

static const bool scattering_parameters_row =
    row("scattering_parameters")
        .inputs([](Draw& draw) {
            return std::tuple_cat(texel(draw),
                                  std::make_tuple(lowest_sun(draw), table_size(draw), table_size(draw),
                                                  even_size(draw), table_size(draw)));
        })
        .cpu([](const auto& atmosphere, const auto& uvw, auto lowest, int nu_size, int mu_s_size, int mu_size,
                int altitude_size) {
            return airlight::scattering_parameters(atmosphere, uvw, lowest, nu_size, mu_s_size, mu_size,
                                                   altitude_size);
        })
        .to_the_bit();

}  // namespace parity
