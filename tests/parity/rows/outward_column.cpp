#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/outward_column.hpp>
#include <airlight/sun_column.hpp>

namespace parity {

static const bool column_sum_row =
    row("column_sum")
        .inputs([](Draw& draw) {
            const auto a = draw.column();
            const float factor = draw.number(-2.0F, 2.0F, {0.0F});
            return std::make_tuple(a, factor, draw.column());
        })
        .cpu([](const auto& a, auto factor, const auto& b) { return airlight::column_sum(a, factor, b); })
        .to_the_bit();

static const bool layers_of_row =
    row("layers_of")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](auto run, const auto& atmosphere) {
            using R = decltype(run);
            return airlight::layers_of<typename R::T, typename R::Scene>(atmosphere);
        })
        .within_bound();

static const bool layer_density_row =
    row("layer_density")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(airlight::layers_of(atmosphere),
                                   glm::max(draw.altitude_in_air(atmosphere), 0.0F));
        })
        .cpu([](auto run, const auto& layers, auto altitude) {
            using R = decltype(run);
            return airlight::layer_density<typename R::T, typename R::Scene>(layers, altitude);
        })
        .within_bound();

/// Altitude of a point in the air, and its height over the terminator's plane.
struct Place {
    airlight::Atmosphere<float> atmosphere;
    float altitude;
    float radius;
    float sun_height;
};

static Place place(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float altitude = glm::max(draw.altitude_in_air(atmosphere), 0.0F);
    const float radius = atmosphere.ground_radius + altitude;
    return Place{atmosphere, altitude, radius,
                 radius * draw.grazing_cosine(atmosphere.ground_radius, altitude)};
}

static airlight::LinePoint<float> towards_sun(const Place& at) {
    return airlight::line_towards_sun(at.altitude, at.radius, 1.0F / at.radius, at.sun_height);
}

static const bool line_point_row =
    row("line_point")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            const auto point = towards_sun(at);
            return std::make_tuple(at.altitude, at.radius, 1.0F / at.radius, point.along,
                                   point.perigee_radius, point.perigee_altitude);
        })
        .cpu([](auto altitude, auto radius, auto inverse_radius, auto along, auto perigee_radius,
                auto perigee_altitude) {
            return airlight::line_point(altitude, radius, inverse_radius, along, perigee_radius,
                                        perigee_altitude);
        })
        .to_the_bit();

static const bool line_towards_sun_row =
    row("line_towards_sun")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            return std::make_tuple(at.altitude, at.radius, 1.0F / at.radius, at.sun_height);
        })
        .cpu([](auto altitude, auto radius, auto inverse_radius, auto sun_height) {
            return airlight::line_towards_sun(altitude, radius, inverse_radius, sun_height);
        })
        .to_the_bit();

static const bool exponential_outwards_row =
    row("exponential_outwards")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            const auto layers = airlight::layers_of(at.atmosphere);
            return std::make_tuple(towards_sun(at), draw.magnitude(1e-9F, 1.0F), layers.rayleigh_height,
                                   layers.rayleigh_root);
        })
        .cpu([](const auto& point, auto density, auto height, auto root) {
            return airlight::exponential_outwards(point, density, height, root);
        })
        .to_the_bit();

static const bool exponential_from_perigee_row =
    row("exponential_from_perigee")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            const auto point = towards_sun(at);
            return std::make_tuple(point.perigee_radius, point.perigee_altitude,
                                   airlight::layers_of(at.atmosphere).mie_height);
        })
        .cpu([](auto perigee_radius, auto perigee_altitude, auto height) {
            return airlight::exponential_from_perigee(perigee_radius, perigee_altitude, height);
        })
        .within_bound();

static const bool column_outwards_row =
    row("column_outwards")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            const auto layers = airlight::layers_of(at.atmosphere);
            const auto point = towards_sun(at);
            const float rayleigh = draw.magnitude(1e-9F, 1.0F);
            return std::make_tuple(
                layers, point,
                airlight::shells_along(layers.ozone, at.atmosphere.ground_radius, point.perigee_altitude),
                airlight::Density<float>{rayleigh, draw.magnitude(1e-9F, 1.0F), 0.0F});
        })
        .cpu([](auto run, const auto& layers, const auto& point, const auto& shells, const auto& density) {
            using R = decltype(run);
            return airlight::column_outwards<typename R::T, typename R::Scene>(layers, point, shells,
                                                                               density);
        })
        .to_the_bit();

static const bool exponentials_through_perigee_row =
    row("exponentials_through_perigee")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            return std::make_tuple(airlight::layers_of(at.atmosphere), towards_sun(at), draw.column());
        })
        .cpu([](auto run, const auto& layers, const auto& point, const auto& outwards) {
            using R = decltype(run);
            return airlight::exponentials_through_perigee<typename R::T, typename R::Scene>(layers, point,
                                                                                            outwards);
        })
        .within_bound();

static const bool exponentials_to_sun_row =
    row("exponentials_to_sun")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            const auto layers = airlight::layers_of(at.atmosphere);
            return std::make_tuple(layers, towards_sun(at), at.sun_height < 0.0F,
                                   airlight::layer_density(layers, at.altitude));
        })
        .cpu([](auto run, const auto& layers, const auto& point, bool sinks, const auto& density) {
            using R = decltype(run);
            return airlight::exponentials_to_sun<typename R::T, typename R::Scene>(layers, point, sinks,
                                                                                   density);
        })
        .within_bound();

static const bool ozone_to_sun_row =
    row("ozone_to_sun")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            return std::make_tuple(airlight::layers_of(at.atmosphere), at.atmosphere.ground_radius,
                                   towards_sun(at), at.sun_height < 0.0F);
        })
        .cpu([](auto run, const auto& layers, auto ground_radius, const auto& point, bool sinks) {
            using R = decltype(run);
            return airlight::ozone_to_sun<typename R::T, typename R::Scene>(layers, ground_radius, point,
                                                                            sinks);
        })
        .to_the_bit();

static const bool column_to_sun_row =
    row("column_to_sun")
        .inputs([](Draw& draw) {
            const Place at = place(draw);
            const auto layers = airlight::layers_of(at.atmosphere);
            return std::make_tuple(layers, at.atmosphere.ground_radius, towards_sun(at), at.sun_height < 0.0F,
                                   airlight::layer_density(layers, at.altitude));
        })
        .cpu([](auto run, const auto& layers, auto ground_radius, const auto& point, bool sinks,
                const auto& density) {
            using R = decltype(run);
            return airlight::column_to_sun<typename R::T, typename R::Scene>(layers, ground_radius, point,
                                                                             sinks, density);
        })
        .within_bound();

}  // namespace parity
