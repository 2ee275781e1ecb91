#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitat.hpp>

#include "../habitats.hpp"

namespace parity {

static const bool spun_density_rise_row =
    row("spun_density_rise")
        .inputs([](Draw& draw) {
            const float spin = draw.magnitude(1e-4F, 10.0F, {0.0F});
            const float gas = draw.magnitude(50.0F, 4e3F);
            return std::make_tuple(spin, gas, draw.magnitude(1.0F, 1e4F));
        })
        .cpu([](auto spin, auto gas, auto temperature) {
            return airlight::spun_density_rise(spin, gas, temperature);
        })
        .to_the_bit();

static const bool spin_for_gravity_row =
    row("spin_for_gravity")
        .inputs([](Draw& draw) {
            const float radius = draw.magnitude(1.0F, 1e7F);
            return std::make_tuple(radius, draw.magnitude(0.01F, 100.0F, {0.0F}));
        })
        .cpu([](auto radius, auto gravity) { return airlight::spin_for_gravity(radius, gravity); })
        .to_the_bit();

static const bool habitat_log_density_row =
    row("habitat_log_density")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            // Behind the wall too, where the density is at its limit.
            return std::make_tuple(air, draw.magnitude(0.1F, 10.0F, {1.0F}) * place_in(draw, air));
        })
        .cpu([](const auto& air, const auto& position) {
            return airlight::habitat_log_density(air, position);
        })
        .to_the_bit();

static const bool habitat_density_row =
    row("habitat_density")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            return std::make_tuple(air, place_in(draw, air));
        })
        .cpu([](const auto& air, const auto& position) { return airlight::habitat_density(air, position); })
        .within_bound();

static const bool mean_of_mild_rise_row =
    row("mean_of_mild_rise")
        .inputs([](Draw& draw) {
            const float middle = draw.number(-20.0F, 0.0F);
            const float slope = draw.number(-0.5F, 0.5F, {0.0F});
            return std::make_tuple(middle, slope, draw.number(0.0F, 0.25F));
        })
        .cpu([](auto middle, auto slope, auto bend) {
            return airlight::mean_of_mild_rise(middle, slope, bend);
        })
        .within_bound();

static const bool habitat_column_row = row("habitat_column")
                                           .inputs([](Draw& draw) {
                                               const auto air = habitat(draw);
                                               const auto from = place_in(draw, air);
                                               return std::make_tuple(air, from, place_in(draw, air));
                                           })
                                           .cpu([](const auto& air, const auto& from, const auto& to) {
                                               return airlight::habitat_column(air, from, to);
                                           })
                                           .within_bound();

static const bool habitat_extinction_row =
    row("habitat_extinction")
        .inputs([](Draw& draw) { return std::make_tuple(habitat(draw)); })
        .cpu([](auto run, const auto& air) {
            using R = decltype(run);
            return airlight::habitat_extinction<typename R::T, typename R::Scene>(air);
        })
        .to_the_bit();

static const bool habitat_transmittance_row =
    row("habitat_transmittance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto from = place_in(draw, air);
            return std::make_tuple(air, from, place_in(draw, air));
        })
        .cpu([](auto run, const auto& air, const auto& from, const auto& to) {
            using R = decltype(run);
            return airlight::habitat_transmittance<typename R::T, typename R::Scene>(air, from, to);
        })
        .within_bound();

static const bool intersect_capped_cylinder_row =
    row("intersect_capped_cylinder")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const float half_length = air.radius * draw.magnitude(0.01F, 100.0F, {3.0F});
            const auto origin = draw.magnitude(0.1F, 10.0F, {1.0F}) * place_in(draw, air);
            return std::make_tuple(air.radius, half_length, origin, draw.direction());
        })
        .cpu([](auto radius, auto half_length, const auto& origin, const auto& direction) {
            return airlight::intersect_capped_cylinder(radius, half_length, origin, direction);
        })
        .to_the_bit();

}  // namespace parity
