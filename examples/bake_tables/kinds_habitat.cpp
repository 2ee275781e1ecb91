// Tables of a habitat: rama_air's cylinder and strips, with the air and the albedo of the chosen planet's
// ground at its wall.

#include <airlight/habitats.hpp>
#include <airlight/tables/habitat.hpp>
#include <cmath>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::vec3;

constexpr int pieces = 4;
constexpr int directions = 128;

template <typename T>
struct Habitat {
    airlight::HabitatAir<T> air;
    airlight::HabitatLights<T> lights;
    vec3<T> albedo;
};

template <typename T>
Habitat<T> habitat_of(const Request& request) {
    const airlight::Atmosphere<double>& planet = request.preset.air;
    Habitat<T> habitat{airlight::rama_air<T>(), airlight::rama_lights<T>(), vec3<T>(planet.ground_albedo)};
    habitat.air.rayleigh_scattering = vec3<T>(planet.rayleigh_scattering);
    habitat.air.mie_scattering = vec3<T>(planet.mie_scattering);
    habitat.air.mie_absorption = vec3<T>(planet.mie_absorption);
    habitat.air.mie_g = T(planet.mie_g);
    return habitat;
}

/// All that texels depend on; of the planet no more than its ground.
support::TableWorld habitat_world(const Request& request) {
    const Habitat<double> habitat = habitat_of<double>(request);
    support::TableWorld world;
    const auto scalar = [&](const std::string& name, double number) {
        world["habitat." + name] = support::number_text(number);
    };
    const auto spectrum = [&](const std::string& name, const vec3<double>& numbers) {
        scalar(name + ".r", numbers.x);
        scalar(name + ".g", numbers.y);
        scalar(name + ".b", numbers.z);
    };
    scalar("radius", habitat.air.radius);
    scalar("density_rise", habitat.air.density_rise);
    spectrum("rayleigh_scattering", habitat.air.rayleigh_scattering);
    spectrum("mie_scattering", habitat.air.mie_scattering);
    spectrum("mie_absorption", habitat.air.mie_absorption);
    scalar("half_length", habitat.lights.half_length);
    scalar("begin", habitat.lights.begin);
    scalar("end", habitat.lights.end);
    scalar("width", habitat.lights.width);
    spectrum("radiance", habitat.lights.radiance);
    scalar("fine", habitat.lights.fine);
    scalar("fine_share", habitat.lights.fine_share);
    spectrum("albedo", habitat.albedo);
    return world;
}

/// The same as uniforms.
std::vector<Setting> habitat_settings(const Request& request) {
    const Habitat<float> habitat = habitat_of<float>(request);
    return {{"habitat.radius", habitat.air.radius},
            {"habitat.density_rise", habitat.air.density_rise},
            {"habitat.rayleigh_scattering", habitat.air.rayleigh_scattering},
            {"habitat.mie_scattering", habitat.air.mie_scattering},
            {"habitat.mie_absorption", habitat.air.mie_absorption},
            {"habitat.mie_g", habitat.air.mie_g},
            {"habitat_lights.half_length", habitat.lights.half_length},
            {"habitat_lights.begin", habitat.lights.begin},
            {"habitat_lights.end", habitat.lights.end},
            {"habitat_lights.width", habitat.lights.width},
            {"habitat_lights.radiance", habitat.lights.radiance},
            {"habitat_lights.fine", habitat.lights.fine},
            {"habitat_lights.fine_share", habitat.lights.fine_share},
            {"albedo", habitat.albedo},
            {"pieces", pieces},
            {"directions", directions}};
}

/// Gives a kind its bakes on the CPU, bake(habitat, request, rows) for float and double, and its world.
template <typename Bake>
void bake_habitat(Kind& kind, const Bake& bake) {
    kind.world = habitat_world;
    kind.size_rule = "give at least 2 texels each way";
    kind.takes_size = [](const support::TableSize& size) {
        return size.width >= 2 && size.height >= 2 && size.depth >= 2;
    };
    kind.on_cpu = [bake](const Request& request, const support::Rows& rows) {
        return bake(habitat_of<float>(request), request, rows);
    };
    kind.in_double = [bake](const Request& request, const support::Rows& rows) {
        return bake(habitat_of<double>(request), request, rows);
    };
}

/// Gives a kind its comparison at one of `every` places, evenly in the cylinder or near its wall:
/// compare(habitat, position, read(position), out).
template <typename Compare>
void compare_in_habitat(Kind& kind, int every, const Compare& compare) {
    kind.compare = [every, compare](const Request& request, const LookUp& look_up,
                                    const PlaceChoice& choice) {
        const Habitat<double> habitat = habitat_of<double>(request);
        Compared all;
        for (int n = 0; n < choice.count; n += every) {
            Draws draws(n, {});
            const double along = 2 * draws.unit() - 1;
            const double angle = 2 * airlight::pi<double> * draws.unit();
            const double inside = draws.unit();
            // Half of them between 2 m and 200 m off the wall, where people are.
            const double from_axis = draws.unit() < 0.5 ? habitat.air.radius * std::sqrt(inside)
                                                        : habitat.air.radius - 2 * std::pow(100.0, inside);
            const vec3<double> position(along * habitat.lights.half_length, from_axis * std::cos(angle),
                                        from_axis * std::sin(angle));
            const auto read = [&](const vec3<double>& place) {
                return look_up(
                    airlight::habitat_texture(airlight::unit_from_habitat(habitat.air, habitat.lights, place),
                                              request.size.width, request.size.height, request.size.depth));
            };
            compare(habitat, position, read, all);
        }
        return all;
    };
}

Numbers one_pass_on_gpu(const Request& request, GpuBaker& gpu, const std::string& shader) {
    const GpuTable table = gpu.make_table(request.size);
    gpu.pass(shader, {&table}, {}, habitat_settings(request));
    return numbers_of(table, 3);
}

Kind habitat_light() {
    Kind kind{"habitat_light",
              "the light of a habitat's six strips, as the document has it",
              {49, 33, 33},
              "unit_from_habitat",
              "mean radiance over all directions",
              "1, per unit of the strips' radiance",
              {"R", "G", "B"}};
    bake_habitat(kind, [](const auto& habitat, const Request& request, const support::Rows& rows) {
        return support::numbers_of(airlight::bake_habitat_light(habitat.air, habitat.lights,
                                                                request.size.width, request.size.height,
                                                                request.size.depth, pieces, rows));
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        return one_pass_on_gpu(request, gpu, "habitat_light");
    };
    compare_in_habitat(
        kind, 1,
        [](const Habitat<double>& habitat, const vec3<double>& position, const auto& read, Compared& all) {
            add(all, read(position),
                airlight::habitat_mean_radiance(habitat.air, habitat.lights, position, 8));
        });
    kind.remark =
        "Half of the places are 2 to 200 m off the wall: beside a strip the light has a peak that no texel "
        "holds.";
    return kind;
}

Kind habitat_passed() {
    Kind kind{
        "habitat_passed",
        "the share of that light which the air lets through: times the light without air, in closed form",
        {49, 33, 33},
        "unit_from_habitat",
        "share in the mean over the strips",
        "1",
        {"R", "G", "B"}};
    bake_habitat(kind, [](const auto& habitat, const Request& request, const support::Rows& rows) {
        return support::numbers_of(airlight::bake_habitat_passed(habitat.air, habitat.lights,
                                                                 request.size.width, request.size.height,
                                                                 request.size.depth, pieces, rows));
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        return one_pass_on_gpu(request, gpu, "habitat_passed");
    };
    compare_in_habitat(
        kind, 1,
        [](const Habitat<double>& habitat, const vec3<double>& position, const auto& read, Compared& all) {
            add(all, read(position), airlight::habitat_mean_passed(habitat.air, habitat.lights, position, 8));
        });
    kind.remark = "At the same places as habitat_light.";
    return kind;
}

/// The same passes as bake_habitat_indirect, after one for what passes.
Numbers indirect_on_gpu(const Request& request, GpuBaker& gpu) {
    std::vector<Setting> settings = habitat_settings(request);
    const GpuTable passed = gpu.make_table(request.size);
    GpuTable mean = gpu.make_table(request.size);
    GpuTable irradiance = gpu.make_table(request.size);
    GpuTable next_mean = gpu.make_table(request.size);
    GpuTable next_irradiance = gpu.make_table(request.size);
    gpu.expect_passes(1 + request.orders);
    gpu.pass("habitat_passed", {&passed}, {}, settings);
    for (int bounce = 0; bounce < request.orders; ++bounce) {
        gpu.pass("habitat_gather", {&next_mean, &next_irradiance},
                 {{"passed_table", &passed}, {"mean_table", &mean}, {"irradiance_table", &irradiance}},
                 settings);
        std::swap(mean, next_mean);
        std::swap(irradiance, next_irradiance);
    }
    return side_by_side({&mean, &irradiance});
}

Kind habitat_indirect() {
    Kind kind{"habitat_indirect",
              "light that a habitat's walls and air have scattered, as many times as --orders",
              {25, 9, 9},
              "unit_from_habitat",
              "mean radiance over all directions; irradiance of a surface that faces as the nearest wall",
              "1 and sr, per unit of the strips' radiance",
              {"mean.R", "mean.G", "mean.B", "irradiance.R", "irradiance.G", "irradiance.B"}};
    kind.has_orders = true;
    kind.small_size = {5, 4, 3};
    bake_habitat(kind, [](const auto& habitat, const Request& request, const support::Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(habitat.air)>>;
        const support::TableSize& size = request.size;
        rows.expect_passes(1 + request.orders);
        const auto passed = airlight::bake_habitat_passed(habitat.air, habitat.lights, size.width,
                                                          size.height, size.depth, pieces, rows);
        const auto tables = airlight::bake_habitat_indirect(
            habitat.air, habitat.lights, habitat.albedo, request.orders, size.width, size.height, size.depth,
            directions, airlight::HabitatPassedTable<T>{&passed}, rows);
        return support::numbers_of(tables.mean, tables.irradiance);
    });
    kind.on_gpu = indirect_on_gpu;
    compare_in_habitat(
        kind, 40,
        [](const Habitat<double>& habitat, const vec3<double>& position, const auto& read, Compared& all) {
            const auto straight = [](const auto& air, const auto& lights, const auto& place) {
                return airlight::habitat_mean_radiance(air, lights, place, 1);
            };
            const auto exact = [&](const vec3<double>& place) {
                return airlight::gathered_habitat_light(habitat.air, habitat.lights, habitat.albedo, place,
                                                        1024, airlight::AlwaysSeen{}, straight);
            };
            add(all, read(position), exact(position).mean);
            const double outward = habitat.air.radius / std::hypot(position.y, position.z);
            const vec3<double> on_wall(position.x, outward * position.y, outward * position.z);
            const std::vector<double> there = read(on_wall);
            add(all, {there.begin() + 3, there.end()}, exact(on_wall).irradiance);
        });
    kind.remark =
        "The errors are those of one bounce, against 1024 directions without a table, at 100 of the places: "
        "of "
        "the\nmean there, and of the irradiance of the wall beside them.";
    return kind;
}

}  // namespace

std::vector<Kind> habitat_kinds() {
    return {habitat_light(), habitat_passed(), habitat_indirect()};
}

}  // namespace bake_tables
