#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/sky_view_mapping.hpp>

#include "table_inputs.hpp"

namespace parity {

static const bool sun_azimuth_cosine_row =
    row("sun_azimuth_cosine")
        .inputs([](Draw& draw) {
            const auto up = draw.direction();
            const auto direction = draw.direction();
            return std::make_tuple(up, direction, draw.direction());
        })
        .cpu([](const auto& up, const auto& direction, const auto& to_sun) {
            return airlight::sun_azimuth_cosine(up, direction, to_sun);
        })
        .to_the_bit();

static const bool sky_direction_row =
    row("sky_direction")
        .inputs([](Draw& draw) {
            const auto up = draw.direction();
            const auto to_sun = draw.one_of({0, 1, 2, 3}) == 0 ? -up : draw.direction();
            const float mu = draw.cosine();
            return std::make_tuple(up, to_sun, mu, draw.cosine());
        })
        .cpu([](const auto& up, const auto& to_sun, auto mu, auto azimuth_cosine) {
            return airlight::sky_direction(up, to_sun, mu, azimuth_cosine);
        })
        .to_the_bit();

static const bool sky_view_uv_row =
    row("sky_view_uv")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            const float mu = draw.cosine();
            const float azimuth = draw.cosine();
            const bool ground = draw.one_of({0, 1}) == 1;
            return std::make_tuple(atmosphere.ground_radius, altitude, mu, azimuth, ground, table_size(draw),
                                   even_size(draw));
        })
        .cpu([](auto radius, auto altitude, auto mu, auto azimuth, bool ground, int width, int height) {
            return airlight::sky_view_uv(radius, altitude, mu, azimuth, ground, width, height);
        })
        .to_the_bit();

static const bool sky_view_parameters_row =
    row("sky_view_parameters")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            const float u = coordinate(draw);
            const airlight::vec2<float> uv(u, coordinate(draw));
            return std::make_tuple(atmosphere.ground_radius, altitude, uv, table_size(draw), even_size(draw));
        })
        .cpu([](auto radius, auto altitude, const auto& uv, int width, int height) {
            return airlight::sky_view_parameters(radius, altitude, uv, width, height);
        })
        .to_the_bit();

static const bool froxel_uvw_row =
    row("froxel_uvw")
        .inputs([](Draw& draw) {
            const float u = coordinate(draw);
            const airlight::vec2<float> screen(u, coordinate(draw));
            const float most = draw.magnitude(1.0F, 1e6F);
            const float distance = draw.number(-0.1F, 1.5F, {0.0F, 1.0F}) * most;
            const int slices = draw.one_of({airlight::slices_linear, airlight::slices_quadratic});
            return std::make_tuple(screen, distance, most, slices, table_size(draw), table_size(draw),
                                   table_size(draw));
        })
        .cpu([](const auto& screen, auto distance, auto most, int slices, int width, int height, int depth) {
            return airlight::froxel_uvw(screen, distance, most, slices, width, height, depth);
        })
        .to_the_bit();

static const bool froxel_parameters_row =
    row("froxel_parameters")
        .inputs([](Draw& draw) {
            const float u = coordinate(draw);
            const float v = coordinate(draw);
            const airlight::vec3<float> uvw(u, v, coordinate(draw));
            const float most = draw.magnitude(1.0F, 1e6F);
            const int slices = draw.one_of({airlight::slices_linear, airlight::slices_quadratic});
            return std::make_tuple(uvw, most, slices, table_size(draw), table_size(draw), table_size(draw));
        })
        .cpu([](const auto& uvw, auto most, int slices, int width, int height, int depth) {
            return airlight::froxel_parameters(uvw, most, slices, width, height, depth);
        })
        .to_the_bit();

}  // namespace parity
