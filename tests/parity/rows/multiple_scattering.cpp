#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/multiple_scattering.hpp>

#include "../views.hpp"

namespace parity {

static const bool node_column_to_eye_row =
    row("node_column_to_eye")
        .inputs([](Draw& draw) {
            const auto [atmosphere, ray, t] = point_of_ray(draw);
            const auto point = airlight::ray_point(atmosphere, ray, t);
            const auto start = airlight::ray_point(atmosphere, ray, 0.0F);
            const float outwards = ray.air.along + t < 0.0F ? -1.0F : 1.0F;
            const auto offset =
                airlight::column_sum(airlight::Column<float>{0.0F, 0.0F, 0.0F}, outwards, start.outwards);
            return std::make_tuple(atmosphere, ray, offset, outwards, point.altitude,
                                   glm::abs(ray.air.along + t), point.density);
        })
        .left_out(0.6, 0.35, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& ray, const auto& offset, auto outwards,
                auto altitude, auto along, const auto& density) {
            using R = decltype(run);
            return airlight::node_column_to_eye<typename R::T, typename R::Scene>(
                atmosphere, ray, offset, outwards, altitude, along, density);
        })
        .within_bound();

static const bool seen_through_row =
    row("seen_through")
        .inputs([](Draw& draw) { return std::make_tuple(draw.spectrum(1e-6F, 1e3F)); })
        .cpu([](const auto& depth) { return airlight::seen_through(depth); })
        .within_bound();

static const bool diffuse_scattering_row =
    row("diffuse_scattering")
        .inputs(view)
        .count(4096)
        .left_out(0.35, 0.2, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance) {
            using R = decltype(run);
            return airlight::diffuse_scattering<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, run.multiple_scattering);
        })
        .within_bound();

static const bool all_scattering_row =
    row("all_scattering")
        .inputs(view)
        .count(1024)
        .left_out(0.35, 0.2, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance) {
            using R = decltype(run);
            return airlight::all_scattering<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, run.multiple_scattering, run.visibility);
        })
        .within_bound();

static const bool diffuse_scattering_marched_row =
    row("diffuse_scattering_marched")
        .inputs([](Draw& draw) {
            return std::tuple_cat(view(draw), std::make_tuple(draw.one_of({0, 1, 5, 16})));
        })
        .count(4096)
        .left_out(0.35, 0.2, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance, int steps) {
            using R = decltype(run);
            return airlight::diffuse_scattering_marched<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, steps, run.multiple_scattering);
        })
        .within_bound();

}  // namespace parity
