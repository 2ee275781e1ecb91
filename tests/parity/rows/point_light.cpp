#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/point_light.hpp>

#include "../habitats.hpp"

namespace parity {

/// Off the axis and the middle, where habitats' rays meet.
static auto lamp_in(Draw& draw, const airlight::HabitatAir<float>& air) {
    const auto position =
        0.9F * place_in(draw, air) + air.radius * airlight::vec3<float>(0.01F, 0.02F, 0.03F);
    const auto intensity = draw.spectrum(0.1F, 10.0F);
    const auto axis = draw.direction();
    const float inner = draw.number(-0.9F, 0.99F);
    const float outer = draw.one_of({0, 1, 2}) == 0 ? -2.0F : inner - draw.number(0.05F, 0.5F);
    return airlight::PointLight<float>{position, intensity, axis, inner, outer};
}

static const bool spot_share_row =
    row("spot_share")
        .inputs([](Draw& draw) {
            const auto light = lamp_in(draw, habitat(draw));
            return std::make_tuple(light, draw.direction());
        })
        .cpu([](const auto& light, const auto& direction) { return airlight::spot_share(light, direction); })
        .to_the_bit();

static const bool point_source_row =
    row("point_source")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto light = lamp_in(draw, air);
            const auto position = place_in(draw, air);
            return std::make_tuple(air, light, position, draw.direction());
        })
        .cpu([](auto run, const auto& air, const auto& light, const auto& position, const auto& direction) {
            using R = decltype(run);
            return airlight::point_source<typename R::T, typename R::Scene>(air, light, position, direction,
                                                                            run.light_visibility);
        })
        .within_bound();

static const bool point_scattering_row =
    row("point_scattering")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            return std::tuple_cat(std::make_tuple(air, lamp_in(draw, air)), ray_in(draw, air));
        })
        .count(2048)
        .cpu([](auto run, const auto& air, const auto& light, const auto& eye, const auto& direction,
                auto distance) {
            using R = decltype(run);
            return airlight::point_scattering<typename R::T, typename R::Scene>(
                air, light, eye, direction, distance, run.light_visibility);
        })
        .within_bound();

}  // namespace parity
