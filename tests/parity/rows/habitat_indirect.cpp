#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitat_indirect.hpp>

#include "../habitats.hpp"

namespace parity {

/// An eye in the middle of the cylinder and a direction.
static auto eye_and_direction(Draw& draw, const airlight::HabitatAir<float>& air) {
    const auto off = airlight::vec3<float>(0.3F, 0.97F, 0.97F);
    const auto eye = off * place_in(draw, air);
    return std::make_tuple(eye, draw.direction());
}

static const bool habitat_normal_row =
    row("habitat_normal")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            // Close to the middle too, where a place is on neither side of anything.
            const float near = draw.one_of({0, 1, 1}) == 0 ? 0.01F : 1.0F;
            return std::make_tuple(air, lights, near * place_in(draw, air));
        })
        .cpu([](const auto& air, const auto& lights, const auto& position) {
            return airlight::habitat_normal(air, lights, position);
        })
        .to_the_bit();

static const bool habitat_wall_row =
    row("habitat_wall")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            return std::tuple_cat(std::make_tuple(air, lights), eye_and_direction(draw, air));
        })
        .cpu([](const auto& air, const auto& lights, const auto& eye, const auto& direction) {
            return airlight::habitat_wall(air, lights, eye, direction);
        })
        .to_the_bit();

static const bool habitat_wall_radiance_row =
    row("habitat_wall_radiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const auto albedo = draw.spectrum(0.05F, 1.0F);
            const auto position = place_in(draw, air);
            return std::make_tuple(air, lights, albedo, position, draw.direction());
        })
        .count(2048)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& albedo, const auto& position,
                const auto& normal) {
            using R = decltype(run);
            return airlight::habitat_wall_radiance<typename R::T, typename R::Scene>(
                air, lights, albedo, position, normal, run.light_visibility, run.indirect_irradiance);
        })
        .within_bound();

static const bool habitat_radiance_row =
    row("habitat_radiance")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const auto albedo = draw.spectrum(0.05F, 1.0F);
            return std::tuple_cat(std::make_tuple(air, lights, albedo), eye_and_direction(draw, air));
        })
        .count(1024)
        .left_out(0.35, 0.01, nearest_strip)
        .cpu([](auto run, const auto& air, const auto& lights, const auto& albedo, const auto& eye,
                const auto& direction) {
            using R = decltype(run);
            return airlight::habitat_radiance<typename R::T, typename R::Scene>(
                air, lights, albedo, eye, direction, run.light_visibility, run.habitat_light,
                run.indirect_irradiance);
        })
        .within_bound();

static const bool sphere_lattice_row =
    row("sphere_lattice")
        .inputs([](Draw& draw) {
            const int count = draw.one_of({1, 2, 7, 32, 128, 1000, 4096});
            return std::make_tuple(int(draw.number(0.0F, 0.99999F) * float(count)), count);
        })
        .cpu([](auto run, int i, int count) {
            return airlight::sphere_lattice<typename decltype(run)::T>(i, count);
        })
        .to_the_bit();

static const bool gathered_habitat_light_row =
    row("gathered_habitat_light")
        .inputs([](Draw& draw) {
            const auto air = habitat(draw);
            const auto lights = lights_in(draw, air);
            const auto albedo = draw.spectrum(0.05F, 1.0F);
            const auto off = airlight::vec3<float>(0.3F, 0.97F, 0.97F);
            const auto position = off * place_in(draw, air);
            // An odd number has a ray straight across, which rounding tilts to either cap.
            return std::make_tuple(air, lights, albedo, position, draw.one_of({0, 2, 4}));
        })
        .count(512)
        .left_out(0.35, 0.04, "up to four rays, each with the branches of habitat_radiance; 0.02 in WebGL")
        .cpu([](auto run, const auto& air, const auto& lights, const auto& albedo, const auto& position,
                int directions) {
            using R = decltype(run);
            return airlight::gathered_habitat_light<typename R::T, typename R::Scene>(
                air, lights, albedo, position, directions, run.light_visibility, run.habitat_light,
                run.indirect_irradiance);
        })
        .within_bound();

}  // namespace parity
