#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/light_shafts.hpp>

#include "../views.hpp"

namespace parity {

/// Atmosphere, a ray in its air, and what makes it ready for shadows.
static auto shaft(Draw& draw) {
    const auto [atmosphere, ray, t] = point_of_ray(draw);
    return std::make_tuple(atmosphere, ray, airlight::shaft_ray<float>(atmosphere, ray));
}

static const bool depth_of_any_legs_row =
    row("depth_of_any_legs")
        .inputs([](Draw& draw) {
            const auto [atmosphere, ray, t] = point_of_ray(draw);
            return std::make_tuple(atmosphere, ray, airlight::ray_legs<float>(atmosphere, ray));
        })
        .cpu([](auto run, const auto& atmosphere, const auto& ray, const auto& legs) {
            using R = decltype(run);
            return airlight::depth_of_any_legs<typename R::T, typename R::Scene>(atmosphere, ray, legs);
        })
        .within_bound();

static const bool shaft_ray_row =
    row("shaft_ray")
        .inputs([](Draw& draw) {
            const auto [atmosphere, ray, t] = point_of_ray(draw);
            return std::make_tuple(atmosphere, ray);
        })
        .left_out(0.4, 0.1, grazing)  // of rays in the air, where of all views a third have none
        .cpu([](auto run, const auto& atmosphere, const auto& ray) {
            using R = decltype(run);
            return airlight::shaft_ray<typename R::T, typename R::Scene>(atmosphere, ray);
        })
        .within_bound();

static const bool shaft_distance_row =
    row("shaft_distance")
        .inputs([](Draw& draw) {
            const auto [atmosphere, lit, ray] = shaft(draw);
            return std::make_tuple(ray, ray.lit_length * draw.number(0.01F, 1.0F));
        })
        .cpu([](const auto& ray, auto lit) { return airlight::shaft_distance(ray, lit); })
        .to_the_bit();

static const bool shaft_piece_end_row =
    row("shaft_piece_end")
        .inputs([](Draw& draw) {
            const auto [atmosphere, lit, ray] = shaft(draw);
            const int pieces = draw.one_of({1, 2, 8, 50});
            return std::make_tuple(ray, draw.one_of({0, 1, pieces / 2, pieces}), pieces);
        })
        .cpu([](const auto& ray, int i, int pieces) { return airlight::shaft_piece_end(ray, i, pieces); })
        .to_the_bit();

static const bool depth_of_share_row =
    row("depth_of_share")
        .inputs([](Draw& draw) {
            const float whole = draw.magnitude(1e-9F, 1.0F, {0.0F});
            return std::make_tuple(whole * draw.number(1e-6F, 1.0F), whole);
        })
        .cpu([](auto part, auto whole) { return airlight::depth_of_share(part, whole); })
        .within_bound();

static const bool source_depth_row =
    row("source_depth")
        .inputs([](Draw& draw) {
            const auto [atmosphere, lit, ray] = shaft(draw);
            return std::make_tuple(atmosphere, lit, ray, ray.lit_length * draw.number(0.01F, 1.0F));
        })
        .left_out(0.35, 0.15, grazing)  // measured: 0.104 in WebGL, whose exp may be off by more
        .cpu([](auto run, const auto& atmosphere, const auto& lit, const auto& ray, auto length) {
            using R = decltype(run);
            return airlight::source_depth<typename R::T, typename R::Scene>(atmosphere, lit, ray, length);
        })
        .within_bound();

static const bool monotone_slope_row =
    row("monotone_slope")
        .inputs([](Draw& draw) {
            const auto slope = draw.spectrum(1e-3F, 50.0F);
            const auto before = draw.spectrum(1e-3F, 50.0F);
            const auto after = draw.spectrum(1e-3F, 50.0F);
            const float side = draw.one_of({0, 1}) == 1 ? 1.0F : -1.0F;
            const float turn = draw.one_of({0, 0, 0, 1}) == 1 ? -1.0F : 1.0F;
            return std::make_tuple(side * slope, side * before, turn * side * after);
        })
        .cpu([](const auto& slope, const auto& before, const auto& after) {
            return airlight::monotone_slope(slope, before, after);
        })
        .to_the_bit();

static const bool shaft_piece_row =
    row("shaft_piece")
        .inputs([](Draw& draw) {
            const auto [atmosphere, lit, ray] = shaft(draw);
            const auto before = draw.spectrum(1e-3F, 46.0F);
            const auto here = draw.spectrum(1e-3F, 46.0F);
            const auto next = draw.spectrum(1e-3F, 46.0F);
            const auto after = draw.spectrum(1e-3F, 46.0F);
            const int pieces = draw.one_of({1, 2, 8, 50});
            return std::make_tuple(ray, before, here, next, after, draw.one_of({0, pieces / 2, pieces - 1}),
                                   pieces);
        })
        .cpu([](const auto& ray, const auto& before, const auto& here, const auto& next, const auto& after,
                int i,
                int pieces) { return airlight::shaft_piece(ray, before, here, next, after, i, pieces); })
        .to_the_bit();

/// A ray and a piece of it.
static auto piece(Draw& draw) {
    const auto [atmosphere, lit, ray] = shaft(draw);
    const auto before = draw.spectrum(1e-3F, 20.0F);
    const auto here = draw.spectrum(1e-3F, 20.0F);
    const auto next = draw.spectrum(1e-3F, 20.0F);
    const auto after = draw.spectrum(1e-3F, 20.0F);
    return std::make_tuple(ray,
                           airlight::shaft_piece(ray, before, here, next, after, draw.one_of({0, 3, 7}), 8));
}

static const bool source_share_row =
    row("source_share")
        .inputs([](Draw& draw) {
            const auto [ray, its_piece] = piece(draw);
            return std::make_tuple(its_piece, draw.number(0.01F, 1.0F));
        })
        .cpu([](const auto& its_piece, auto x) { return airlight::source_share(its_piece, x); })
        .within_bound();

static const bool light_between_row =
    row("light_between")
        .inputs([](Draw& draw) {
            const auto [ray, its_piece] = piece(draw);
            const float one = draw.number(0.01F, 1.0F);
            const float other = draw.number(0.01F, 1.0F);
            return std::make_tuple(ray, its_piece, glm::min(one, other), glm::max(one, other));
        })
        .cpu([](const auto& ray, const auto& its_piece, auto from, auto to) {
            return airlight::light_between(ray, its_piece, from, to);
        })
        .within_bound();

static const bool light_lost_in_shadow_row =
    row("light_lost_in_shadow")
        .inputs([](Draw& draw) {
            const auto inputs = view(draw);
            const float range = draw.distance(std::get<0>(inputs));
            const int pieces = draw.one_of({0, 1, 2, 8});
            const int looks = draw.one_of({0, 1, 4});
            return std::tuple_cat(inputs, std::make_tuple(range, pieces, looks, draw.number(0.01F, 1.0F)));
        })
        .count(4096)
        .left_out(0.35, 0.1, grazing)
        .hooked_everywhere()  // without shadow nothing is lost
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance, auto range, int pieces, int looks, auto offset) {
            using R = decltype(run);
            return airlight::light_lost_in_shadow<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, range, pieces, looks, offset, run.visibility);
        })
        .within_bound();

}  // namespace parity
