#include <airlight/table_mapping.hpp>
#include <airlight/transmittance.hpp>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::AltitudeCosine;
using airlight::vec2;
using airlight::vec3;

/// One pass, one texture of three numbers.
auto one_pass(const std::string& shader) {
    return [shader](const Request& request, GpuBaker& gpu) {
        const GpuTable table = gpu.make_table(request.size);
        gpu.pass(shader, {&table});
        return numbers_of(table, 3);
    };
}

Kind transmittance() {
    Kind kind{"transmittance",
              "share of light that reaches space, in Bruneton's mapping; ignores the ground",
              {256, 64, 1},
              "transmittance_uv",
              "share of light that passes from a point to space, were there no ground",
              "1",
              {"R", "G", "B"}};
    bake_each_alone(kind, [](auto scene, const auto& air, const auto& uvw, const support::TableSize& size) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        const AltitudeCosine<T> at =
            airlight::transmittance_parameters(air, vec2<T>(uvw.x, uvw.y), size.width, size.height);
        return airlight::transmittance<T, decltype(scene)>(air, at.altitude, at.mu,
                                                           airlight::no_surface<T>());
    });
    kind.on_gpu = one_pass("transmittance");
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const double altitude = draws.altitude(air);
        const double mu = draws.sky_cosine(air, altitude);
        const vec3<double> at(
            airlight::transmittance_uv(air, altitude, mu, request.size.width, request.size.height), 0.5);
        add(all, look_up(at),
            airlight::transmittance<double, decltype(scene)>(air, altitude, mu,
                                                             airlight::no_surface<double>()));
    });
    return kind;
}

Kind extinction() {
    Kind kind{"extinction",
              "share of light that reaches space, plainly over altitude and angle; 0 behind the planet",
              {256, 256, 1},
              "extinction_uv",
              "share of light that passes from a point to space, 0 where the planet is in the way",
              "1",
              {"R", "G", "B"}};
    bake_each_alone(kind, [](auto scene, const auto& air, const auto& uvw, const support::TableSize& size) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        const AltitudeCosine<T> at =
            airlight::extinction_parameters(air, vec2<T>(uvw.x, uvw.y), size.width, size.height);
        return airlight::transmittance_to_space<T, decltype(scene)>(air, at.altitude, at.mu);
    });
    kind.on_gpu = one_pass("extinction");
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const double altitude = draws.altitude(air);
        const double mu = draws.sky_cosine(air, altitude);
        const vec3<double> at(
            airlight::extinction_uv(air, altitude, mu, request.size.width, request.size.height), 0.5);
        add(all, look_up(at), airlight::transmittance_to_space<double, decltype(scene)>(air, altitude, mu));
    });
    return kind;
}

}  // namespace

std::vector<Kind> transmittance_kinds() {
    return {transmittance(), extinction()};
}

}  // namespace bake_tables
