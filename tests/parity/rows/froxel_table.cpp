#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/froxel_table.hpp>

#include "table_inputs.hpp"

namespace parity {

static const bool camera_direction_row =
    row("camera_direction")
        .inputs([](Draw& draw) {
            const auto centre = draw.direction();
            const auto right = 0.5F * draw.direction();
            const airlight::CameraRays<float> camera{centre, right, 0.25F * draw.direction()};
            const float u = coordinate(draw);
            return std::make_tuple(camera, airlight::vec2<float>(u, coordinate(draw)));
        })
        .cpu(
            [](const auto& camera, const auto& screen) { return airlight::camera_direction(camera, screen); })
        .to_the_bit();

static const bool depth_of_transmittance_row =
    row("depth_of_transmittance")
        .inputs(
            [](Draw& draw) { return std::make_tuple(draw.spectrum(1e-30F, 1.5F)); })  // above 1 counts as 1
        .cpu([](const auto& transmittance) { return airlight::depth_of_transmittance(transmittance); })
        .within_bound();

static const bool direction_above_ground_row =
    row("direction_above_ground")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const auto eye = draw.viewpoint(atmosphere);
            const auto direction = draw.view(atmosphere, eye);
            return std::make_tuple(atmosphere, eye, direction, draw.distance(atmosphere));
        })
        .cpu([](const auto& atmosphere, const auto& eye, const auto& direction, auto distance) {
            return airlight::direction_above_ground(atmosphere, eye, direction, distance);
        })
        .to_the_bit();

static const bool froxel_texel_row =
    row("froxel_texel")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const auto eye = draw.viewpoint(atmosphere);
            const auto direction = draw.view(atmosphere, eye);
            const auto to_sun = draw.direction_at(eye.up, static_cast<double>(draw.cosine()));
            return std::make_tuple(atmosphere, eye, direction, to_sun, draw.distance(atmosphere));
        })
        .count(1024)
        .left_out(0.45, 0.2,
                  "lifted rays touch the ground where their slice ends, and suns exactly behind or across "
                  "the ray are "
                  "end points: rounding decides how long the ray or its shadow is")
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance) {
            using R = decltype(run);
            return airlight::froxel_texel<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, run.multiple_scattering, run.visibility);
        })
        .within_bound();

static const bool froxel_light_row =
    row("froxel_light")
        .inputs([](Draw& draw) {
            const float u = coordinate(draw);
            const airlight::vec2<float> screen(u, coordinate(draw));
            const float most = draw.magnitude(1.0F, 1e6F);
            // Not at a slice, on either side of which the same light is found by other numbers.
            const float distance = draw.number(0.013F, 0.987F) * most;
            const int slices = draw.one_of({airlight::slices_linear, airlight::slices_quadratic});
            const int width = table_size(draw);
            const int height = table_size(draw);
            return std::make_tuple(screen, distance, most, slices, width, height, draw.one_of({2, 8, 32}));
        })
        .cpu([](auto run, const auto& screen, auto distance, auto most, int slices, int width, int height,
                int depth) {
            return airlight::froxel_light(screen, distance, most, slices, width, height, depth,
                                          run.froxel_table);
        })
        .within_bound();

}  // namespace parity
