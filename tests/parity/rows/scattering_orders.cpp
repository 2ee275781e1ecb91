#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/scattering_orders.hpp>

#include "table_ray.hpp"

namespace parity {

using airlight::NoIncidentLight;
using airlight::NoIrradiance;
using airlight::NoOrderRadiance;
using airlight::NothingGathered;

static const bool table_air_ray_row =
    row("table_air_ray")
        .inputs([](Draw& draw) {
            const auto [atmosphere, altitude, mu, mu_s, nu, reaches_ground] = table_ray(draw);
            return std::make_tuple(atmosphere, altitude, mu, reaches_ground);
        })
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu([](const auto& atmosphere, auto altitude, auto mu, bool reaches_ground) {
            return airlight::table_air_ray(atmosphere, altitude, mu, reaches_ground);
        })
        .to_the_bit();

/// Atmosphere, a ray of table_air_ray that is in the air, mu, mu_s, nu.
static auto ray_of_table(Draw& draw) {
    const auto [atmosphere, altitude, mu, mu_s, nu, reaches_ground] = table_ray(draw);
    const auto air = airlight::table_air_ray(atmosphere, altitude, mu, reaches_ground);
    return air.in_air ? std::make_tuple(atmosphere, air, mu, mu_s, nu)
                      : std::make_tuple(atmosphere, airlight::table_air_ray(atmosphere, 0.0F, 1.0F, false),
                                        1.0F, mu_s, mu_s);
}

static const bool table_lit_ray_row =
    row("table_lit_ray")
        .inputs(ray_of_table)
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu([](auto run, const auto& atmosphere, const auto& air, auto mu, auto mu_s, auto nu) {
            using R = decltype(run);
            return airlight::table_lit_ray<typename R::T, typename R::Scene>(atmosphere, air, mu, mu_s, nu);
        })
        .within_bound();

static const bool share_found_row =
    row("share_found")
        .inputs([](Draw& draw) {
            const float found = draw.magnitude(1e-6F, 10.0F, {0.0F});
            return std::make_tuple(found, draw.magnitude(1e-6F, 1.0F, {0.0F}));
        })
        .cpu([](auto found, auto lost) { return airlight::share_found(found, lost); })
        .to_the_bit();

static const bool energy_share_row =
    row("energy_share")
        .inputs([](Draw& draw) {
            const auto found = draw.spectrum(1e-6F, 10.0F);
            return std::make_tuple(found, draw.spectrum(1e-6F, 1e3F));
        })
        .cpu([](const auto& found, const auto& depth) { return airlight::energy_share(found, depth); })
        .within_bound();

static const bool single_inscatter_row =
    row("single_inscatter")
        .inputs(table_ray)
        .count(4096)
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto mu_s, auto nu,
                bool reaches_ground) {
            using R = decltype(run);
            return airlight::single_inscatter<typename R::T, typename R::Scene>(atmosphere, altitude, mu,
                                                                                mu_s, nu, reaches_ground);
        })
        .within_bound();

/// The ground's radius, an altitude, a direction of the rule.
static auto direction_of_rule(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const float altitude = draw.altitude_in_air(atmosphere);
    const int side = draw.one_of({0, 1});
    const int polar = draw.one_of({0, 1, 2});  // three nodes are the fewest of any scene
    return std::make_tuple(atmosphere, glm::max(altitude, 0.0F), side, polar,
                           draw.one_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

static const bool incident_light_row =
    row("incident_light")
        .inputs([](Draw& draw) {
            const auto [atmosphere, altitude, side, polar, azimuth] = direction_of_rule(draw);
            return std::make_tuple(atmosphere, altitude, draw.cosine(), side, polar, azimuth);
        })
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu(
            [](auto run, const auto& atmosphere, auto altitude, auto mu_s, int side, int polar, int azimuth) {
                using R = decltype(run);
                return airlight::incident_light<typename R::T, typename R::Scene>(
                    atmosphere, altitude, mu_s, side, polar, azimuth,
                    hook_of<NoOrderRadiance, StandInTable>(run), hook_of<NoIrradiance, StandInTable>(run));
            })
        .within_bound();

static const bool phase_weighted_light_row =
    row("phase_weighted_light")
        .inputs([](Draw& draw) {
            const auto [atmosphere, altitude, mu, mu_s, nu, reaches_ground] = table_ray(draw);
            return std::make_tuple(atmosphere, altitude, mu, mu_s, nu);
        })
        .count(512)
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto mu_s, auto nu) {
            using R = decltype(run);
            return airlight::phase_weighted_light<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu, mu_s, nu, hook_of<NoIncidentLight, StandInTable>(run));
        })
        .to_the_bit();

static const bool extinction_at_row =
    row("extinction_at")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.altitude_in_air(atmosphere));
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude) {
            using R = decltype(run);
            return airlight::extinction_at<typename R::T, typename R::Scene>(atmosphere, altitude);
        })
        .within_bound();

static const bool scattered_at_row =
    row("scattered_at")
        .inputs(table_ray)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto mu_s, auto nu,
                bool reaches_ground) {
            using R = decltype(run);
            const auto table = hook_of<NothingGathered, StandInTable>(run);
            return airlight::scattered_at<typename R::T, typename R::Scene>(atmosphere, altitude, mu, mu_s,
                                                                            nu, reaches_ground, table, table);
        })
        .within_bound();

static const bool missed_light_row =
    row("missed_light")
        .inputs([](Draw& draw) {
            const float found = draw.magnitude(1e-6F, 2.0F, {0.0F});
            const float lost = draw.magnitude(1e-6F, 1.0F, {0.0F});
            const float source = draw.magnitude(1e-9F, 1e-3F, {0.0F});
            return std::make_tuple(found, lost, source, draw.magnitude(1e-9F, 1e-3F, {0.0F}));
        })
        .cpu([](auto found, auto lost, auto source, auto extinction) {
            return airlight::missed_light(found, lost, source, extinction);
        })
        .to_the_bit();

static const bool next_order_radiance_row =
    row("next_order_radiance")
        .inputs(table_ray)
        .count(4096)
        .left_out(0.35, 0.1, table_rays_left_out)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu, auto mu_s, auto nu,
                bool reaches_ground) {
            using R = decltype(run);
            return airlight::next_order_radiance<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu, mu_s, nu, reaches_ground,
                hook_of<NothingGathered, StandInTable>(run), hook_of<NothingGathered, StandInTable>(run));
        })
        .within_bound();

static const bool order_irradiance_row =
    row("order_irradiance")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude_in_air(atmosphere);
            return std::make_tuple(atmosphere, altitude, draw.cosine());
        })
        .count(1024)
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s) {
            using R = decltype(run);
            return airlight::order_irradiance<typename R::T, typename R::Scene>(
                atmosphere, altitude, mu_s, hook_of<NoOrderRadiance, StandInTable>(run));
        })
        .to_the_bit();

}  // namespace parity
