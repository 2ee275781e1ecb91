#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/sky_view_table.hpp>

#include "table_inputs.hpp"

namespace parity {

/// Atmosphere, altitude of an eye, the sun's cosine, a direction of the table.
static auto place_of_texel(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float altitude = draw.altitude(atmosphere);
    const float mu_s = draw.cosine();
    const float u = coordinate(draw);
    const airlight::vec2<float> uv(u, coordinate(draw));
    return std::make_tuple(atmosphere, altitude, mu_s,
                           airlight::sky_view_parameters(atmosphere.ground_radius, altitude, uv, 192, 108));
}

static const bool sky_view_ray_row =
    row("sky_view_ray")
        .inputs(place_of_texel)
        .cpu([](const auto& atmosphere, auto altitude, auto mu_s, const auto& seen) {
            return airlight::sky_view_ray(atmosphere, altitude, mu_s, seen);
        })
        .to_the_bit();

static const bool sky_view_texel_row =
    row("sky_view_texel")
        .inputs([](Draw& draw) {
            // Not straight up or down, nor at the horizon: sky_view_ray has those, and all_scattering.
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.number(0.001F, 0.9F) * atmosphere.top_altitude;
            const float mu_s = draw.number(-0.3F, 0.98F);
            const float u = draw.number(0.01F, 0.99F);
            const airlight::vec2<float> uv(u, draw.number(0.01F, 0.98F));
            return std::make_tuple(
                atmosphere, altitude, mu_s,
                airlight::sky_view_parameters(atmosphere.ground_radius, altitude, uv, 192, 108));
        })
        .count(1024)
        .left_out(
            0.35, 0.2,
            "eyes at the top of the air, and suns exactly behind or across the ray, are end points where "
            "rounding decides how long the ray or its shadow is")
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s, const auto& seen) {
            using R = decltype(run);
            return airlight::sky_view_texel<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu_s, seen, run.multiple_scattering, run.visibility);
        })
        .within_bound();

static const bool sky_view_place_row =
    row("sky_view_place")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const auto eye = draw.viewpoint(atmosphere);
            const auto direction = draw.view(atmosphere, eye);
            const auto to_sun = draw.direction();
            return std::make_tuple(atmosphere, eye, direction, to_sun, table_size(draw), even_size(draw));
        })
        .cpu([](const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun, int width,
                int height) {
            return airlight::sky_view_place(atmosphere, eye, direction, to_sun, width, height);
        })
        .to_the_bit();

}  // namespace parity
