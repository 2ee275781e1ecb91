#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/column.hpp>
#include <airlight/optical_depth.hpp>
#include <airlight/transmittance.hpp>

namespace parity {

static auto ray(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float altitude = draw.altitude(atmosphere);
    const float mu = draw.grazing_cosine(atmosphere.ground_radius + atmosphere.top_altitude,
                                         altitude - atmosphere.top_altitude);
    return std::make_tuple(atmosphere, altitude, mu, draw.distance(atmosphere));
}

static const bool relative_density_row =
    row("relative_density")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.altitude(atmosphere));
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude) {
            using R = decltype(run);
            return airlight::relative_density<typename R::T, typename R::Scene>(atmosphere, altitude);
        })
        .within_bound();

static const bool air_path_row = row("air_path")
                                     .inputs(ray)
                                     .cpu([](const auto& atmosphere, auto altitude, auto mu, auto distance) {
                                         return airlight::air_path(atmosphere, altitude, mu, distance);
                                     })
                                     .to_the_bit();

static auto path(Draw& draw) {
    return std::apply(
        [](const auto& atmosphere, float altitude, float mu, float distance) {
            return std::make_tuple(atmosphere, airlight::air_path(atmosphere, altitude, mu, distance));
        },
        ray(draw));
}

static const bool exponential_column_row =
    row("exponential_column")
        .inputs([](Draw& draw) {
            const auto [atmosphere, air] = path(draw);
            return std::make_tuple(atmosphere.ground_radius, air, atmosphere.rayleigh_scale_height);
        })
        .cpu([](auto radius, const auto& air, auto scale_height) {
            return airlight::exponential_column(radius, air, scale_height);
        })
        .within_bound();

static const bool distance_to_shell_row =
    row("distance_to_shell")
        .inputs([](Draw& draw) {
            const auto [atmosphere, air] = path(draw);
            return std::make_tuple(atmosphere.ground_radius, air, draw.altitude_in_air(atmosphere),
                                   draw.one_of({0, 1}) == 1);
        })
        .cpu([](auto radius, const auto& air, auto altitude, bool climbing) {
            return airlight::distance_to_shell(radius, air, altitude, climbing);
        })
        .to_the_bit();

static const bool layer_column_row =
    row("layer_column")
        .inputs([](Draw& draw) {
            const auto [atmosphere, air] = path(draw);
            const float low = draw.altitude_in_air(atmosphere);
            return std::make_tuple(atmosphere, air, low, low + draw.magnitude(1.0F, 1e5F, {0.0F}));
        })
        .cpu([](auto run, const auto& atmosphere, const auto& air, auto low, auto high) {
            using R = decltype(run);
            return airlight::layer_column<typename R::T, typename R::Scene>(atmosphere, air, low, high);
        })
        .within_bound();

static const bool ozone_column_row =
    row("ozone_column")
        .inputs(path)
        .cpu([](auto run, const auto& atmosphere, const auto& air) {
            using R = decltype(run);
            return airlight::ozone_column<typename R::T, typename R::Scene>(atmosphere, air);
        })
        .within_bound();

static const bool column_row =
    row("column")
        .inputs(ray)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto distance) {
            using R = decltype(run);
            return airlight::column<typename R::T, typename R::Scene>(atmosphere, altitude, mu, distance);
        })
        .within_bound();

static const bool column_to_space_row =
    row("column_to_space")
        .inputs([](Draw& draw) {
            const auto [atmosphere, altitude, mu, distance] = ray(draw);
            return std::make_tuple(atmosphere, altitude, mu);
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu) {
            using R = decltype(run);
            return airlight::column_to_space<typename R::T, typename R::Scene>(atmosphere, altitude, mu);
        })
        .within_bound();

static const bool column_marched_row =
    row("column_marched")
        .inputs([](Draw& draw) {
            return std::tuple_cat(ray(draw), std::make_tuple(draw.one_of({0, 1, 2, 7, 32})));
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto distance, int steps) {
            using R = decltype(run);
            return airlight::column_marched<typename R::T, typename R::Scene>(atmosphere, altitude, mu,
                                                                              distance, steps);
        })
        .within_bound();

static const bool column_optical_depth_row =
    row("column_optical_depth")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.column());
        })
        .cpu([](auto run, const auto& atmosphere, const auto& column) {
            using R = decltype(run);
            return airlight::column_optical_depth<typename R::T, typename R::Scene>(atmosphere, column);
        })
        .to_the_bit();

static const bool optical_depth_row =
    row("optical_depth")
        .inputs(ray)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto distance) {
            using R = decltype(run);
            return airlight::optical_depth<typename R::T, typename R::Scene>(atmosphere, altitude, mu,
                                                                             distance);
        })
        .within_bound();

static const bool mean_passed_row =
    row("mean_passed")
        .inputs([](Draw& draw) {
            const auto depth = draw.spectrum(1e-9F, 1e2F);
            return std::make_tuple(depth, glm::exp(-depth));
        })
        .cpu([](const auto& depth, const auto& passed) { return airlight::mean_passed(depth, passed); })
        .to_the_bit();

static const bool transmittance_row =
    row("transmittance")
        .inputs(ray)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto distance) {
            using R = decltype(run);
            return airlight::transmittance<typename R::T, typename R::Scene>(atmosphere, altitude, mu,
                                                                             distance);
        })
        .within_bound();

static const bool behind_planet_row =
    row("behind_planet")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            return std::make_tuple(atmosphere.ground_radius, altitude,
                                   draw.grazing_cosine(atmosphere.ground_radius, altitude));
        })
        .cpu(
            [](auto radius, auto altitude, auto mu) { return airlight::behind_planet(radius, altitude, mu); })
        .to_the_bit();

static const bool transmittance_to_space_row =
    row("transmittance_to_space")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            return std::make_tuple(atmosphere, altitude,
                                   draw.grazing_cosine(atmosphere.ground_radius, altitude));
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu) {
            using R = decltype(run);
            return airlight::transmittance_to_space<typename R::T, typename R::Scene>(atmosphere, altitude,
                                                                                      mu);
        })
        .within_bound();

}  // namespace parity
