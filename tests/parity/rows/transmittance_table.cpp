#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/transmittance_table.hpp>

#include "table_inputs.hpp"

namespace parity {

static float upward(Draw& draw) {
    return glm::abs(draw.cosine());
}

static const bool slant_guess_row =
    row("slant_guess")
        .inputs([](Draw& draw) { return std::make_tuple(draw.magnitude(1.0F, 1e6F, {0.0F}), upward(draw)); })
        .cpu([](auto x, auto mu) { return airlight::slant_guess(x, mu); })
        .to_the_bit();

static const bool slant_scale_row =
    row("slant_scale")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](const auto& atmosphere) { return airlight::slant_scale(atmosphere); })
        .to_the_bit();

static const bool slant_uv_row =
    row("slant_uv")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude_in_air(atmosphere);
            const float mu = upward(draw);
            const int width = table_size(draw);
            return std::make_tuple(atmosphere, altitude, mu, width, table_size(draw));
        })
        .cpu([](const auto& atmosphere, auto altitude, auto mu, int width, int height) {
            return airlight::slant_uv(atmosphere, altitude, mu, width, height);
        })
        .to_the_bit();

static const bool slant_parameters_row =
    row("slant_parameters")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float u = coordinate(draw);
            const airlight::vec2<float> uv(u, coordinate(draw));
            const int width = table_size(draw);
            return std::make_tuple(atmosphere, uv, width, table_size(draw));
        })
        .cpu([](const auto& atmosphere, const auto& uv, int width, int height) {
            return airlight::slant_parameters(atmosphere, uv, width, height);
        })
        .to_the_bit();

static const bool slant_texel_row =
    row("slant_texel")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = height_in_air(draw, atmosphere);
            return std::make_tuple(atmosphere, altitude, upward(draw));
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu) {
            using R = decltype(run);
            return airlight::slant_texel<typename R::T, typename R::Scene>(atmosphere, altitude, mu);
        })
        .to_the_bit();

/// Atmosphere, altitude, cosine, size of the table.
static auto ray_to_space(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float altitude = height_in_air(draw, atmosphere);
    const float mu = draw.grazing_cosine(atmosphere.ground_radius, altitude);
    const int width = table_size(draw);
    return std::make_tuple(atmosphere, altitude, mu, width, table_size(draw));
}

static const bool column_from_slants_row =
    row("column_from_slants")
        .inputs(ray_to_space)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, int width, int height) {
            using R = decltype(run);
            return airlight::column_from_slants<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu, width, height, run.slant_table);
        })
        .within_bound();

static const bool transmittance_from_slants_row =
    row("transmittance_from_slants")
        .inputs(ray_to_space)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, int width, int height) {
            using R = decltype(run);
            return airlight::transmittance_from_slants<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu, width, height, run.slant_table);
        })
        .within_bound();

}  // namespace parity
