#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/linear_light.hpp>

#include "../habitats.hpp"

namespace parity {

/// A strip and a place that sees it.
static auto strip_and_place(Draw& draw) {
    const auto air = habitat(draw);
    const auto light = strip_in(draw, air);
    return std::make_tuple(light, place_in(draw, air));
}

static auto view_of_strip(Draw& draw) {
    const auto [light, position] = strip_and_place(draw);
    return airlight::strip_view(light, position);
}

static const bool strip_view_row =
    row("strip_view")
        .inputs(strip_and_place)
        .cpu([](const auto& light, const auto& position) { return airlight::strip_view(light, position); })
        .to_the_bit();

static const bool corner_solid_angle_row = row("corner_solid_angle")
                                               .inputs([](Draw& draw) {
                                                   const float a = draw.magnitude(0.01F, 1e3F, {0.0F});
                                                   const float b = draw.number(-32.0F, 32.0F, {0.0F});
                                                   const float width = draw.magnitude(1e-3F, 1.0F);
                                                   const float height = draw.magnitude(1e-6F, 32.0F);
                                                   return std::make_tuple(a, b, b + width, height);
                                               })
                                               .cpu([](auto a, auto b_0, auto b_1, auto height) {
                                                   return airlight::corner_solid_angle(a, b_0, b_1, height);
                                               })
                                               .to_the_bit();

static const bool strip_point_row =
    row("strip_point")
        .inputs([](Draw& draw) {
            const auto view = view_of_strip(draw);
            return std::make_tuple(view, draw.number(0.001F, 0.999F, {0.5F}));
        })
        .cpu([](const auto& view, auto share) { return airlight::strip_point(view, share); })
        .to_the_bit();

static const bool strip_corner_row =
    row("strip_corner")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto position = place_in(draw, air);
            const float along = draw.one_of({0, 1}) == 0 ? -1.0F : 1.0F;
            const float across = draw.one_of({0, 1}) == 0 ? -1.0F : 1.0F;
            return std::make_tuple(light, position, along, across);
        })
        .cpu([](const auto& light, const auto& position, auto along, auto across) {
            return airlight::strip_corner(light, position, along, across);
        })
        .to_the_bit();

static const bool strip_nearness_row =
    row("strip_nearness")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto [light, position] = strip_and_place_near_it(draw, air);
            return std::make_tuple(airlight::strip_view(light, position), light.width);
        })
        .cpu([](const auto& view, auto width) { return airlight::strip_nearness(view, width); })
        .to_the_bit();

static const bool strip_part_above_row =
    row("strip_part_above")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto position = place_in(draw, air);
            return std::make_tuple(airlight::strip_view(light, position), draw.direction());
        })
        .cpu([](const auto& view, const auto& normal) { return airlight::strip_part_above(view, normal); })
        .to_the_bit();

static const bool arc_irradiance_row = row("arc_irradiance")
                                           .inputs([](Draw& draw) {
                                               const auto begin = draw.direction();
                                               const auto end = draw.direction();
                                               return std::make_tuple(begin, end, draw.direction());
                                           })
                                           .cpu([](const auto& begin, const auto& end, const auto& normal) {
                                               return airlight::arc_irradiance(begin, end, normal);
                                           })
                                           .to_the_bit();

static const bool light_edge_row = row("light_edge")
                                       .inputs([](Draw& draw) {
                                           const auto begin = draw.direction();
                                           const auto end = draw.direction();
                                           return std::make_tuple(begin, end, draw.direction());
                                       })
                                       .cpu([](const auto& begin, const auto& end, const auto& normal) {
                                           return airlight::light_edge(begin, end, normal);
                                       })
                                       .to_the_bit();

static const bool near_strip_irradiance_row =
    row("near_strip_irradiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto [light, position] = strip_and_place_near_it(draw, air);
            return std::make_tuple(light, position, draw.direction());
        })
        .cpu([](const auto& light, const auto& position, const auto& normal) {
            return airlight::near_strip_irradiance(light, position, normal);
        })
        .left_out(0.25, 0.03, "a corner of the strip often lies in the plane; measured: 0.018 in WebGL")
        .to_the_bit();

static const bool strip_irradiance_row =
    row("strip_irradiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto near = strip_and_place_near_it(draw, air);
            const auto anywhere = strip_and_place(draw);
            return std::tuple_cat(draw.one_of({0, 1}) == 0 ? near : anywhere,
                                  std::make_tuple(draw.direction()));
        })
        .cpu([](const auto& light, const auto& position, const auto& normal) {
            return airlight::strip_irradiance(light, position, normal);
        })
        .to_the_bit();

}  // namespace parity
