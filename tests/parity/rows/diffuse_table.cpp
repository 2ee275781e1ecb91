#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/diffuse_table.hpp>

namespace parity {

static const bool diffuse_table_uv_row =
    row("diffuse_table_uv")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.altitude_in_air(atmosphere), draw.cosine(),
                                   draw.one_of({1, 2, 16, 64, 256}), draw.one_of({1, 2, 16, 64}));
        })
        .cpu([](const auto& atmosphere, auto altitude, auto mu_s, int width, int height) {
            return airlight::diffuse_table_uv(atmosphere, altitude, mu_s, width, height);
        })
        .to_the_bit();

static const bool diffuse_table_parameters_row =
    row("diffuse_table_parameters")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.atmosphere(),
                                   airlight::vec2<float>(draw.number(0.0F, 1.0F), draw.number(0.0F, 1.0F)),
                                   draw.one_of({1, 2, 16, 64, 256}), draw.one_of({1, 2, 16, 64}));
        })
        .cpu([](const auto& atmosphere, const auto& uv, int width, int height) {
            return airlight::diffuse_table_parameters(atmosphere, uv, width, height);
        })
        .to_the_bit();

static const bool log_of_light_row =
    row("log_of_light")
        .inputs([](Draw& draw) { return std::make_tuple(draw.spectrum(1e-29F, 1e2F)); })
        .cpu([](const auto& radiance) { return airlight::log_of_light(radiance); })
        .within_bound();

static const bool packed_diffuse_light_row =
    row("packed_diffuse_light")
        .inputs([](Draw& draw) { return std::make_tuple(draw.diffuse_light()); })
        .cpu([](const auto& light) { return airlight::packed_diffuse_light(light); })
        .within_bound();

static const bool unpacked_diffuse_light_row =
    row("unpacked_diffuse_light")
        .inputs(
            [](Draw& draw) { return std::make_tuple(airlight::packed_diffuse_light(draw.diffuse_light())); })
        .cpu([](const auto& texels) { return airlight::unpacked_diffuse_light(texels); })
        .within_bound();

static const bool packed_sky_irradiance_row =
    row("packed_sky_irradiance")
        .inputs([](Draw& draw) { return std::make_tuple(draw.sky_irradiance()); })
        .cpu([](const auto& sky) { return airlight::packed_sky_irradiance(sky); })
        .within_bound();

static const bool unpacked_sky_irradiance_row =
    row("unpacked_sky_irradiance")
        .inputs([](Draw& draw) {
            return std::make_tuple(airlight::packed_sky_irradiance(draw.sky_irradiance()));
        })
        .cpu([](const auto& texels) { return airlight::unpacked_sky_irradiance(texels); })
        .within_bound();

}  // namespace parity
