#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/ambient.hpp>
#include <airlight/compose.hpp>
#include <airlight/single_scattering.hpp>

namespace parity {

static const bool mie_phase_row =
    row("mie_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine(), draw.aerosol_parameter()); })
        .cpu([](auto run, auto cos_theta, auto g) {
            using R = decltype(run);
            return airlight::mie_phase<typename R::T, typename R::Scene>(cos_theta, g);
        })
        .within_bound();

static const bool single_scattering_marched_row =
    row("single_scattering_marched")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const auto eye = draw.viewpoint(atmosphere);
            const auto direction = draw.view(atmosphere, eye);
            // Anywhere in the sky, straight up, straight down, along the view ray and against it.
            const int sun = draw.one_of({0, 0, 0, 0, 1, 2, 3, 4});
            const auto to_sun =
                sun == 0 ? draw.direction_at(eye.up, static_cast<double>(draw.cosine()))
                         : (sun == 1 ? eye.up : (sun == 2 ? -eye.up : (sun == 3 ? direction : -direction)));
            return std::make_tuple(atmosphere, eye, direction, to_sun, draw.distance(atmosphere),
                                   draw.one_of({0, 1, 5, 16}));
        })
        .count(4096)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance, int steps) {
            using R = decltype(run);
            return airlight::single_scattering_marched<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, steps, run.visibility);
        })
        .within_bound();

static const bool ambient_radiance_row =
    row("ambient_radiance")
        .inputs([](Draw& draw) {
            const auto scattering = draw.spectrum(1e-9F, 1e-3F);
            const float column = draw.magnitude(1.0F, 1e6F, {0.0F});
            return std::make_tuple(scattering, column, draw.spectrum(1e-6F, 1e3F));
        })
        .cpu([](const auto& scattering, auto column, const auto& depth) {
            return airlight::ambient_radiance(scattering, column, depth);
        })
        .within_bound();

static const bool compose_row =
    row("compose")
        .inputs([](Draw& draw) {
            const auto surface = draw.spectrum(1e-6F, 1e6F);
            const auto radiance = draw.spectrum(1e-9F, 1.0F);
            const auto transmittance = draw.spectrum(1e-6F, 1.0F);
            return std::make_tuple(surface, airlight::Scattered<float>{radiance, transmittance},
                                   draw.spectrum(1e-3F, 1e5F));
        })
        .cpu([](const auto& surface, const auto& scattered, const auto& sun) {
            return airlight::compose(surface, scattered, sun);
        })
        .to_the_bit();

}  // namespace parity
