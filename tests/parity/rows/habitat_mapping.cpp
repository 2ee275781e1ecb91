#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitat_mapping.hpp>

#include "../habitats.hpp"

namespace parity {

static const bool habitat_strip_row =
    row("habitat_strip")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            return std::make_tuple(air, lights, draw.one_of({0, 1, 2, 3, 4, 5}));
        })
        .cpu([](const auto& air, const auto& lights, int i) {
            return airlight::habitat_strip(air, lights, i);
        })
        .to_the_bit();

static const bool passed_of_stretch_row =
    row("passed_of_stretch")
        .inputs([](Draw& draw) {
            const float begin = draw.number(-10.0F, 10.0F);
            const float length = draw.magnitude(1e-3F, 10.0F, {0.0F});
            return std::make_tuple(draw.number(-20.0F, 20.0F), begin, begin + length);
        })
        .cpu([](auto x, auto begin, auto end) { return airlight::passed_of_stretch(x, begin, end); })
        .to_the_bit();

static const bool share_of_half_row =
    row("share_of_half")
        .inputs([](Draw& draw) {
            const auto lights = lights_in(draw, habitat(draw));
            return std::make_tuple(lights, lights.half_length * draw.number(0.0F, 1.1F));
        })
        .cpu([](const auto& lights, auto x) { return airlight::share_of_half(lights, x); })
        .to_the_bit();

static const bool place_of_half_row =
    row("place_of_half")
        .inputs([](Draw& draw) {
            const auto lights = lights_in(draw, habitat(draw));
            return std::make_tuple(lights, draw.number(0.0F, 1.1F));
        })
        .cpu([](const auto& lights, auto share) { return airlight::place_of_half(lights, share); })
        .to_the_bit();

static const bool unit_from_habitat_row =
    row("unit_from_habitat")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            return std::make_tuple(air, lights, place_in(draw, air));
        })
        .cpu([](const auto& air, const auto& lights, const auto& position) {
            return airlight::unit_from_habitat(air, lights, position);
        })
        .to_the_bit();

static const bool habitat_from_unit_row =
    row("habitat_from_unit")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const float x = draw.number(0.0F, 1.0F);
            const float y = draw.number(0.0F, 1.0F);
            const float z = draw.magnitude(0.02F, 1.0F, {0.0F});
            return std::make_tuple(air, lights, airlight::vec3<float>(x, y, z));
        })
        .cpu([](const auto& air, const auto& lights, const auto& unit) {
            return airlight::habitat_from_unit(air, lights, unit);
        })
        .to_the_bit();

static const bool habitat_texture_row =
    row("habitat_texture")
        .inputs([](Draw& draw) {
            const float x = draw.number(0.0F, 1.0F);
            const float y = draw.number(0.0F, 1.0F);
            const float z = draw.number(0.0F, 1.0F);
            return std::make_tuple(airlight::vec3<float>(x, y, z), draw.one_of({1, 49}), draw.one_of({1, 33}),
                                   draw.one_of({1, 33}));
        })
        .cpu([](const auto& unit, int width, int height, int depth) {
            return airlight::habitat_texture(unit, width, height, depth);
        })
        .to_the_bit();

}  // namespace parity
