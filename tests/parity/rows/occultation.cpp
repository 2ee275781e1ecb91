#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/occultation.hpp>

namespace parity {

static const bool segment_over_chord_row =
    row("segment_over_chord")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.number(-0.1F, 1.1F, {0.0F, 1.0F}));
        })
        .cpu([](auto chord_distance) { return airlight::segment_over_chord(chord_distance); })
        .to_the_bit();

/// From beside the other disc to wholly behind it, with all the ends where one becomes the other.
static airlight::Occultation<float> occultation(Draw& draw) {
    const float curvature = draw.magnitude(1e-6F, 1e3F, {0.0F, 1.0F});
    const float inside = curvature > 1.0F ? 1.0F - 2.0F / curvature : -1.0F;
    const float gap = draw.number(-1.25F, 1.25F, {-1.0F, 0.0F, 1.0F, inside});
    return {curvature * gap < -1.0F ? inside : gap, curvature};
}

static const bool visible_share_row =
    row("visible_share")
        .inputs([](Draw& draw) { return std::make_tuple(occultation(draw)); })
        .cpu([](const auto& between) { return airlight::visible_share(between); })
        .to_the_bit();

static const bool visible_share_of_light_row =
    row("visible_share_of_light")
        .inputs([](Draw& draw) {
            const float curvature = draw.magnitude(1e-2F, 30.0F, {0.0F});
            const float gap = draw.number(-1.25F, 1.25F);
            return std::make_tuple(airlight::Occultation<float>{glm::max(gap, -1.0F / curvature), curvature},
                                   draw.number(0.1F, 2.0F, {0.0F, 1.0F}));
        })
        .left_out(0.4, 0.01, "eight discs, each of which touches the other one somewhere")
        .cpu([](const auto& between, auto limb_exponent) {
            return airlight::visible_share_of_light(between, limb_exponent);
        })
        .within_bound();

static const bool occultation_of_disc_row =
    row("occultation_of_disc")
        .inputs([](Draw& draw) {
            const float between = draw.cosine();
            const float sphere = glm::abs(draw.cosine());
            const auto sine = [](float cosine) { return glm::sqrt((1.0F - cosine) * (1.0F + cosine)); };
            return std::make_tuple(between, sine(between), sphere, sine(sphere),
                                   draw.magnitude(1e-6F, 1.0F, {0.0F, 0.00465F}));
        })
        .cpu([](auto cos_between, auto sin_between, auto cos_sphere, auto sin_sphere, auto sin_radius) {
            return airlight::occultation_of_disc(cos_between, sin_between, cos_sphere, sin_sphere,
                                                 sin_radius);
        })
        .to_the_bit();

static const bool occultation_by_ground_row =
    row("occultation_by_ground")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float radius = atmosphere.ground_radius;
            const float altitude = draw.altitude(atmosphere);
            return std::make_tuple(radius, altitude, draw.grazing_cosine(radius, altitude),
                                   draw.magnitude(1e-6F, 1.0F, {0.0F, 0.00465F}));
        })
        .cpu([](auto radius, auto altitude, auto mu_s, auto sin_radius) {
            return airlight::occultation_by_ground(radius, altitude, mu_s, sin_radius);
        })
        .to_the_bit();

/// A sphere somewhere, or in front of the sun: centre, radius, direction to the sun, its size.
static auto sphere(Draw& draw) {
    const float radius = draw.magnitude(1e-3F, 1e8F, {0.0F, 1.7374e6F});
    const auto to_sun = draw.direction();
    // Angular radii from a quarter turn to nothing; 1 and less is inside.
    const float reach = draw.magnitude(0.5F, 1e4F, {0.0F, 1.0F, 215.0F});
    const auto to_sphere =
        draw.one_of({0, 1}) == 0
            ? draw.direction()
            : draw.direction_at(to_sun, 1.0 - 1.0 / static_cast<double>(reach * reach + 1.0F));
    return std::make_tuple(to_sphere * (reach * radius), radius, to_sun,
                           draw.magnitude(1e-4F, 1.0F, {0.0F, 0.00465F}));
}

static const bool occultation_by_sphere_row =
    row("occultation_by_sphere")
        .inputs(sphere)
        .cpu([](const auto& centre, auto radius, const auto& to_sun, auto sin_radius) {
            return airlight::occultation_by_sphere(centre, radius, to_sun, sin_radius);
        })
        .to_the_bit();

static const bool sunlight_past_sphere_row =
    row("sunlight_past_sphere")
        .inputs([](Draw& draw) {
            return std::tuple_cat(sphere(draw), std::make_tuple(draw.number(0.1F, 2.0F, {0.0F, 0.5F})));
        })
        .left_out(0.4, 0.01, "eight discs, each of which touches the other one somewhere")
        .cpu([](const auto& centre, auto radius, const auto& to_sun, auto sin_radius, auto limb_exponent) {
            return airlight::sunlight_past_sphere(centre, radius, to_sun, sin_radius, limb_exponent);
        })
        .within_bound();

static const bool sunlight_past_ground_row =
    row("sunlight_past_ground")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float radius = atmosphere.ground_radius;
            const auto eye = draw.viewpoint(atmosphere);
            const auto to_sun =
                draw.direction_at(eye.up, static_cast<double>(draw.grazing_cosine(radius, eye.altitude)));
            const float reach = draw.magnitude(1e-6F, 2.0F, {0.0F}) * radius;
            return std::make_tuple(radius, eye, draw.direction() * reach, to_sun,
                                   draw.magnitude(1e-4F, 1.0F, {0.0F, 0.00465F}),
                                   draw.number(0.1F, 2.0F, {0.0F, 0.5F}));
        })
        .left_out(0.4, 0.01, "eight discs, each of which touches the other one somewhere")
        .cpu([](auto radius, const auto& eye, const auto& position, const auto& to_sun, auto sin_radius,
                auto limb_exponent) {
            return airlight::sunlight_past_ground(radius, eye, position, to_sun, sin_radius, limb_exponent);
        })
        .within_bound();

}  // namespace parity
