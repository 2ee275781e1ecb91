#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/ozone_ramps.hpp>

#include "scenes.hpp"

namespace parity {

static const bool span_slopes_row =
    row("span_slopes")
        .inputs([](Draw& draw) {
            const float low = draw.number(0.0F, 5e4F, {0.0F});
            const airlight::vec3<float> at(low, low + draw.magnitude(1.0F, 1e4F, {0.0F}), 6e4F);
            return std::make_tuple(draw.magnitude(1e5F, 1e8F), at, airlight::vec3<float>(at.y, at.z, at.z),
                                   draw.spectrum(1e-6F, 1.0F), draw.spectrum(1e-6F, 1.0F));
        })
        .cpu([](auto ground_radius, const auto& low, const auto& high, const auto& low_density,
                const auto& high_density) {
            return airlight::span_slopes(ground_radius, low, high, low_density, high_density);
        })
        .to_the_bit();

static const bool tent_ramps_row =
    row("tent_ramps")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](const auto& atmosphere) { return airlight::tent_ramps(atmosphere); })
        .to_the_bit();

static const bool lorentzian_at_row =
    row("lorentzian_at")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.magnitude(3e3F, 1e5F), draw.spectrum(1e2F, 1e5F),
                                   draw.spectrum(0.5F, 1.0F));
        })
        .cpu([](const auto& atmosphere, auto rayleigh_height, const auto& altitude, const auto& share) {
            return airlight::lorentzian_at(atmosphere, rayleigh_height, altitude, share);
        })
        .within_bound();

static const bool lorentzian_ramps_row =
    row("lorentzian_ramps")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](const auto& atmosphere) { return airlight::lorentzian_ramps(atmosphere); })
        .within_bound();

static const bool ozone_ramps_row =
    row("ozone_ramps")
        .inputs([](Draw& draw) { return std::make_tuple(draw.atmosphere()); })
        .cpu([](auto run, const auto& atmosphere) {
            using R = decltype(run);
            return airlight::ozone_ramps<typename R::T, typename R::Scene>(atmosphere);
        })
        .within_bound();

/// An atmosphere and the altitude of a line's closest approach in it.
static auto line_in_air(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    return std::make_tuple(atmosphere, draw.altitude_in_air(atmosphere));
}

static const bool crossings_row =
    row("crossings")
        .inputs([](Draw& draw) {
            const auto [atmosphere, perigee_altitude] = line_in_air(draw);
            return std::make_tuple(airlight::tent_ramps(atmosphere).altitudes.first, atmosphere.ground_radius,
                                   perigee_altitude);
        })
        .cpu([](const auto& altitudes, auto ground_radius, auto perigee_altitude) {
            return airlight::crossings(altitudes, ground_radius, perigee_altitude);
        })
        .to_the_bit();

static const bool shells_along_row =
    row("shells_along")
        .inputs([](Draw& draw) {
            const auto [atmosphere, perigee_altitude] = line_in_air(draw);
            return std::make_tuple(airlight::lorentzian_ramps(atmosphere), atmosphere.ground_radius,
                                   perigee_altitude);
        })
        .cpu([](auto run, const auto& ramps, auto ground_radius, auto perigee_altitude) {
            using R = decltype(run);
            return airlight::shells_along<typename R::T, typename R::Scene>(ramps, ground_radius,
                                                                            perigee_altitude);
        })
        .to_the_bit();

static const bool ramps_beyond_row =
    row("ramps_beyond")
        .inputs([](Draw& draw) {
            const auto [atmosphere, perigee_altitude] = line_in_air(draw);
            const auto ramps = airlight::tent_ramps(atmosphere);
            const auto shells =
                airlight::crossings(ramps.altitudes.first, atmosphere.ground_radius, perigee_altitude);
            return std::make_tuple(ramps.weights.first, shells,
                                   draw.number(-1.2F, 1.2F, {0.0F, 1.0F, -1.0F}) * shells.z);
        })
        .cpu([](const auto& weights, const auto& shells, auto along) {
            return airlight::ramps_beyond(weights, shells, along);
        })
        .to_the_bit();

static const bool ozone_beyond_row =
    row("ozone_beyond")
        .inputs([](Draw& draw) {
            const auto [atmosphere, perigee_altitude] = line_in_air(draw);
            const auto ramps = airlight::lorentzian_ramps(atmosphere);
            const auto shells =
                airlight::shells_along<float, Lorentzian>(ramps, atmosphere.ground_radius, perigee_altitude);
            return std::make_tuple(ramps, shells,
                                   draw.number(-1.2F, 1.2F, {0.0F, 1.0F, -1.0F}) * shells.fourth.z);
        })
        .cpu([](auto run, const auto& ramps, const auto& shells, auto along) {
            using R = decltype(run);
            return airlight::ozone_beyond<typename R::T, typename R::Scene>(ramps, shells, along);
        })
        .to_the_bit();

}  // namespace parity
