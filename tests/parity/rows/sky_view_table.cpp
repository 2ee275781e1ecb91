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
        .inputs(place_of_texel)
        .count(4096)
        .left_out(
            0.35, 0.1,
            "eyes at the top of the air, and suns exactly behind or across the ray, are end points where "
            "rounding decides how long the ray or its shadow is")
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s, const auto& seen) {
            using R = decltype(run);
            return airlight::sky_view_texel<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu_s, seen, airlight::NoDiffuseLight{}, run.visibility);
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
