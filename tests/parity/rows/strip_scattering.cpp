#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/strip_scattering.hpp>

#include "../habitats.hpp"

namespace parity {

static const bool habitat_scattering_row =
    row("habitat_scattering")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const float density = draw.magnitude(1e-6F, 1.0F, {0.0F});
            return std::make_tuple(air, density, draw.cosine());
        })
        .cpu([](auto run, const auto& air, auto density, auto cos_theta) {
            using R = decltype(run);
            return airlight::habitat_scattering<typename R::T, typename R::Scene>(air, density, cos_theta);
        })
        .within_bound();

static const bool light_reaching_row =
    row("light_reaching")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light_position = place_in(draw, air);
            return std::make_tuple(air, light_position, place_in(draw, air));
        })
        .cpu([](auto run, const auto& air, const auto& light_position, const auto& position) {
            using R = decltype(run);
            return airlight::light_reaching<typename R::T, typename R::Scene>(air, light_position, position,
                                                                              run.light_visibility);
        })
        .within_bound();

static const bool strip_cosine_row =
    row("strip_cosine")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto view = airlight::strip_view(strip_in(draw, air), place_in(draw, air));
            const auto to_light = airlight::strip_point(view, draw.number(0.001F, 0.999F, {0.5F}));
            return std::make_tuple(view, to_light, draw.direction());
        })
        .cpu([](const auto& view, const auto& to_light, const auto& direction) {
            return airlight::strip_cosine(view, to_light, direction);
        })
        .to_the_bit();

static const bool air_beside_strip_row =
    row("air_beside_strip")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto [light, position] = strip_and_place_near_it(draw, air);
            const auto view = airlight::strip_view(light, position);
            const auto direction = draw.direction();
            return std::make_tuple(air, light, view, position, direction, draw.one_of({0, 1, 1, 3}));
        })
        .cpu([](auto run, const auto& air, const auto& light, const auto& view, const auto& position,
                const auto& direction, int pieces) {
            using R = decltype(run);
            return airlight::air_beside_strip<typename R::T, typename R::Scene>(air, light, view, position,
                                                                                direction, pieces);
        })
        .within_bound();

static const bool strip_source_row =
    row("strip_source")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto position = place_in(draw, air);
            const auto direction = draw.direction();
            return std::make_tuple(air, light, position, direction, draw.one_of({0, 1, 1, 3}));
        })
        .cpu([](auto run, const auto& air, const auto& light, const auto& position, const auto& direction,
                int pieces) {
            using R = decltype(run);
            return airlight::strip_source<typename R::T, typename R::Scene>(air, light, position, direction,
                                                                            pieces, run.light_visibility);
        })
        .within_bound();

static const bool strip_mean_radiance_row =
    row("strip_mean_radiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto position = place_in(draw, air);
            return std::make_tuple(air, light, position, draw.one_of({0, 1, 1, 3}));
        })
        .cpu([](auto run, const auto& air, const auto& light, const auto& position, int pieces) {
            using R = decltype(run);
            return airlight::strip_mean_radiance<typename R::T, typename R::Scene>(
                air, light, position, pieces, run.light_visibility);
        })
        .within_bound();

static const bool isotropic_source_row =
    row("isotropic_source")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto position = place_in(draw, air);
            return std::make_tuple(air, position, draw.spectrum(0.01F, 10.0F));
        })
        .cpu([](auto run, const auto& air, const auto& position, const auto& mean_radiance) {
            using R = decltype(run);
            return airlight::isotropic_source<typename R::T, typename R::Scene>(air, position, mean_radiance);
        })
        .within_bound();

static const bool nearest_to_strip_row =
    row("nearest_to_strip")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto eye = place_in(draw, air);
            const auto direction = draw.direction();
            return std::make_tuple(light, eye, direction, air.radius * draw.magnitude(1e-3F, 6.0F, {0.0F}));
        })
        .cpu([](const auto& light, const auto& eye, const auto& direction, auto distance) {
            return airlight::nearest_to_strip(light, eye, direction, distance);
        })
        .to_the_bit();

static const bool area_sine_row = row("area_sine")
                                      .inputs([](Draw& draw) {
                                          return std::make_tuple(draw.magnitude(1e-6F, 1e6F, {0.0F, 0.1F}));
                                      })
                                      .cpu([](auto x) { return airlight::area_sine(x); })
                                      .within_bound();

static const bool peak_node_row =
    row("peak_node")
        .inputs([](Draw& draw) {
            const float distance = draw.magnitude(1.0F, 1e6F, {0.0F});
            const float peak = distance * draw.number(0.0F, 1.0F);
            const float width = draw.magnitude(1e-4F, 1e3F) * glm::max(distance, 1.0F);
            return std::make_tuple(peak, width, distance, draw.one_of({0, 1, 2}));
        })
        .cpu([](auto run, auto peak, auto width, auto distance, int i) {
            using R = decltype(run);
            return airlight::peak_node<typename R::T, typename R::Scene>(peak, width, distance, i);
        })
        .within_bound();

static const bool peak_width_row =
    row("peak_width")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            const auto position = place_in(draw, air);
            return std::make_tuple(light, position, air.radius * draw.magnitude(1e-3F, 6.0F, {0.0F}));
        })
        .cpu([](const auto& light, const auto& position, auto distance) {
            return airlight::peak_width(light, position, distance);
        })
        .to_the_bit();

/// A strip, and a ray that flies along it half of the time.
static auto strip_and_ray(Draw& draw) {
    const auto air = habitat(draw);
    const auto light = strip_in(draw, air);
    const auto eye = place_in(draw, air);
    const auto aside = draw.direction();
    const auto direction =
        draw.one_of({0, 1}) == 0 ? aside : glm::normalize(light.along + draw.magnitude(1e-3F, 0.3F) * aside);
    return std::make_tuple(light, eye, direction, air.radius * draw.magnitude(1e-3F, 6.0F, {0.0F}));
}

static const bool strip_approach_row =
    row("strip_approach")
        .inputs(strip_and_ray)
        .left_out(0.35, 0.01, "where the ray is nearest to the strip: often at its end, or at the eye")
        .cpu([](const auto& light, const auto& eye, const auto& direction, auto distance) {
            return airlight::strip_approach(light, eye, direction, distance);
        })
        .to_the_bit();

static const bool peak_stretch_row =
    row("peak_stretch")
        .inputs([](Draw& draw) {
            const auto [light, eye, direction, distance] = strip_and_ray(draw);
            const auto approach = airlight::strip_approach(light, eye, direction, distance);
            return std::make_tuple(approach, distance, draw.one_of({0, 1}));
        })
        .cpu([](const auto& approach, auto distance, int i) {
            return airlight::peak_stretch(approach, distance, i);
        })
        .to_the_bit();

static const bool strip_scattering_row =
    row("strip_scattering")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = strip_in(draw, air);
            return std::tuple_cat(std::make_tuple(air, light), ray_in(draw, air),
                                  std::make_tuple(draw.one_of({0, 1})));
        })
        .count(1024)
        .cpu([](auto run, const auto& air, const auto& light, const auto& eye, const auto& direction,
                auto distance, int pieces) {
            using R = decltype(run);
            return airlight::strip_scattering<typename R::T, typename R::Scene>(
                air, light, eye, direction, distance, pieces, run.light_visibility);
        })
        .within_bound();

}  // namespace parity
