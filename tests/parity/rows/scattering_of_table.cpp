#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/scattering_of_table.hpp>

#include "table_ray.hpp"

namespace parity {

using airlight::NoMultipleRadiance;
using airlight::NothingScattered;

static const bool radiance_of_table_row =
    row("radiance_of_table")
        .inputs(table_ray)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto mu_s, auto nu,
                bool reaches_ground) {
            using R = decltype(run);
            const auto table = hook_of<NothingScattered, StandInTable>(run);
            const auto more = hook_of<NoMultipleRadiance, StandInTable>(run);
            return airlight::radiance_of_table<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu, mu_s, nu, reaches_ground, table, table, more);
        })
        .to_the_bit();

static const bool scattering_of_table_row =
    row("scattering_of_table")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const auto eye = draw.viewpoint(atmosphere);
            const auto direction = draw.view(atmosphere, eye);
            const auto to_sun = draw.direction_at(eye.up, static_cast<double>(draw.cosine()));
            return std::make_tuple(atmosphere, eye, direction, to_sun, draw.distance(atmosphere));
        })
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu([](auto run, const auto& atmosphere, const auto& eye, const auto& direction, const auto& to_sun,
                auto distance) {
            using R = decltype(run);
            const auto table = hook_of<NothingScattered, StandInTable>(run);
            const auto more = hook_of<NoMultipleRadiance, StandInTable>(run);
            return airlight::scattering_of_table<typename R::T, typename R::Scene>(
                atmosphere, eye, direction, to_sun, distance, table, table, more);
        })
        .within_bound();

}  // namespace parity
