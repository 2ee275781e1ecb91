#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/aerial_perspective.hpp>
#include <airlight/ambient.hpp>
#include <airlight/compose.hpp>
#include <airlight/single_scattering.hpp>
#include <airlight/sky.hpp>

#include "../views.hpp"

namespace parity {

static const bool lit_ray_row = row("lit_ray")
                                    .inputs(ray_in_air)
                                    .cpu([](auto run, const auto& atmosphere, const auto& air,
                                            const auto& eye, const auto& direction, const auto& to_sun) {
                                        using R = decltype(run);
                                        return airlight::lit_ray<typename R::T, typename R::Scene>(
                                            atmosphere, air, eye, direction, to_sun);
                                    })
                                    .within_bound();

static const bool ray_point_row =
    row("ray_point")
        .inputs(point_of_ray)
        .cpu([](auto run, const auto& atmosphere, const auto& ray, auto t) {
            using R = decltype(run);
            return airlight::ray_point<typename R::T, typename R::Scene>(atmosphere, ray, t);
        })
        .within_bound();

static const bool guiding_depth_row =
    row("guiding_depth")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.column());
        })
        .cpu([](auto run, const auto& atmosphere, const auto& column) {
            using R = decltype(run);
            return airlight::guiding_depth<typename R::T, typename R::Scene>(atmosphere, column);
        })
        .to_the_bit();

static const bool piece_map_row =
    row("piece_map")
        .inputs([](Draw& draw) {
            const auto [atmosphere, ray, t] = point_of_ray(draw);
            // The piece from the ray's start, or from its closest approach, to t.
            const float turn = glm::clamp(-ray.air.along, 0.0F, ray.air.extent);
            const float begin = t > turn ? turn : 0.0F;
            const auto from = airlight::ray_point(atmosphere, ray, begin);
            const auto to = airlight::ray_point(atmosphere, ray, t);
            const bool climbs = begin >= turn;
            const float low_along = glm::abs(ray.air.along + (climbs ? begin : t));
            return std::make_tuple(atmosphere, ray, climbs ? from : to, climbs ? to : from, low_along,
                                   t - begin, climbs ? 1.0F : -1.0F);
        })
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& ray, const auto& low, const auto& high,
                auto low_along, auto extent, auto outwards) {
            using R = decltype(run);
            return airlight::piece_map<typename R::T, typename R::Scene>(atmosphere, ray, low, high,
                                                                         low_along, extent, outwards);
        })
        .within_bound();

/// Atmosphere, a lit ray and what a node of it is told by.
static auto node_of_ray(Draw& draw) {
    const auto [atmosphere, ray, t] = point_of_ray(draw);
    const auto point = airlight::ray_point(atmosphere, ray, t);
    const auto start = airlight::ray_point(atmosphere, ray, 0.0F);
    const float outwards = ray.air.along + t < 0.0F ? -1.0F : 1.0F;
    const auto offset =
        airlight::column_sum(airlight::Column<float>{0.0F, 0.0F, 0.0F}, outwards, start.outwards);
    return std::make_tuple(atmosphere, ray, offset, outwards, point.altitude, glm::abs(ray.air.along + t),
                           point.density);
}

static const bool node_transmittance_row =
    row("node_transmittance")
        .inputs(node_of_ray)
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& ray, const auto& offset, auto outwards,
                auto altitude, auto along, const auto& density) {
            using R = decltype(run);
            return airlight::node_transmittance<typename R::T, typename R::Scene>(
                atmosphere, ray, offset, outwards, altitude, along, density);
        })
        .within_bound();

static const bool node_radiance_row =
    row("node_radiance")
        .inputs(node_of_ray)
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& ray, const auto& offset, auto outwards,
                auto altitude, auto along, const auto& density) {
            using R = decltype(run);
            return airlight::node_radiance<typename R::T, typename R::Scene>(
                atmosphere, ray, offset, outwards, altitude, along, density);
        })
        .within_bound();

static const bool most_scattered_row =
    row("most_scattered")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float cos_theta = draw.cosine();
            const auto depth = draw.spectrum(1e-6F, 1e3F);
            return std::make_tuple(atmosphere, cos_theta, depth, glm::exp(-depth));
        })
        .cpu([](auto run, const auto& atmosphere, auto cos_theta, const auto& depth,
                const auto& transmittance) {
            using R = decltype(run);
            return airlight::most_scattered<typename R::T, typename R::Scene>(atmosphere, cos_theta, depth,
                                                                              transmittance);
        })
        .within_bound();

static const bool single_scattering_row =
    row("single_scattering")
        .inputs(view)
        .count(4096)
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance) {
            using R = decltype(run);
            return airlight::single_scattering<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, run.visibility);
        })
        .within_bound();

static const bool single_scattering_marched_row =
    row("single_scattering_marched")
        .inputs([](Draw& draw) {
            return std::tuple_cat(view(draw), std::make_tuple(draw.one_of({0, 1, 5, 16})));
        })
        .count(4096)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance, int steps) {
            using R = decltype(run);
            return airlight::single_scattering_marched<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, steps, run.visibility,
                run.transmittance_to_space);
        })
        .within_bound();

static const bool ambient_radiance_row =
    row("ambient_radiance")
        .inputs([](Draw& draw) {
            const auto scattering = draw.spectrum(1e-9F, 1e-3F);
            const float column = draw.magnitude(1.0F, 1e6F, {0.0F});
            return std::make_tuple(scattering, column, draw.spectrum(1e-6F, 1e3F));
        })
        .cpu([](const auto& scattering, auto column, const auto& depth) {
            return airlight::ambient_radiance(scattering, column, depth);
        })
        .within_bound();

static const bool compose_row =
    row("compose")
        .inputs([](Draw& draw) {
            const auto surface = draw.spectrum(1e-6F, 1e6F);
            const auto radiance = draw.spectrum(1e-9F, 1.0F);
            const auto transmittance = draw.spectrum(1e-6F, 1.0F);
            return std::make_tuple(surface, airlight::Scattered<float>{radiance, transmittance},
                                   draw.spectrum(1e-3F, 1e5F));
        })
        .cpu([](const auto& surface, const auto& scattered, const auto& sun) {
            return airlight::compose(surface, scattered, sun);
        })
        .to_the_bit();

// In this file because they call single_scattering, which takes long to compile in all scenes.

static const bool sky_radiance_row =
    row("sky_radiance")
        .inputs([](Draw& draw) {
            const auto [atmosphere, eye, direction, to_sun, distance] = view(draw);
            airlight::SunDisc<float> sun = airlight::solar_disc<float>();
            sun.sin_edge = draw.magnitude(1e-4F, 1.0F, {0.0F});
            return std::make_tuple(atmosphere, eye, direction, to_sun, sun);
        })
        .count(4096)
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                const auto& sun) {
            using R = decltype(run);
            return airlight::sky_radiance<typename R::T, typename R::Scene>(atmosphere, eye, direction,
                                                                            to_sun, sun, run.visibility);
        })
        .within_bound();

static const bool aerial_perspective_row =
    row("aerial_perspective")
        .inputs([](Draw& draw) {
            return std::tuple_cat(view(draw), std::make_tuple(draw.spectrum(1e-6F, 1e3F)));
        })
        .count(4096)
        .left_out(0.35, 0.1, grazing)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance, const auto& surface) {
            using R = decltype(run);
            return airlight::aerial_perspective<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, surface, run.visibility);
        })
        .within_bound();

static const bool sky_with_sun_row =
    row("sky_with_sun")
        .inputs([](Draw& draw) {
            const auto [atmosphere, eye, direction, to_sun, distance] = view(draw);
            airlight::SunDisc<float> sun = airlight::solar_disc<float>();
            sun.sin_edge = draw.magnitude(1e-4F, 1.0F, {0.0F});
            const auto air =
                airlight::Scattered<float>{draw.spectrum(1e-9F, 1.0F), draw.spectrum(1e-6F, 1.0F)};
            return std::make_tuple(atmosphere, eye, direction, to_sun, sun, air);
        })
        .cpu([](const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                const auto& sun, const auto& air) {
            return airlight::sky_with_sun(atmosphere, eye, direction, to_sun, sun, air);
        })
        .within_bound();

static const bool without_aerosol_glow_row =
    row("without_aerosol_glow")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](const auto& atmosphere) { return airlight::without_aerosol_glow(atmosphere); })
        .to_the_bit();

}  // namespace parity
