#include <airlight/table_mapping.hpp>
#include <airlight/transmittance.hpp>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::AltitudeCosine;
using airlight::Table;
using airlight::vec2;
using airlight::vec3;

Kind transmittance() {
    Kind kind{"transmittance",
              "share of light that reaches space, Bruneton's mapping; ignores the ground",
              {256, 64, 1},
              false,
              "transmittance_uv",
              "share of light that passes from a point to space, were there no ground",
              "1",
              {"R", "G", "B"},
              false,
              {},
              {},
              {},
              {},
              {}};
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        Table<vec3<T>> table = airlight::make_table<vec3<T>>(request.size.width, request.size.height);
        const auto texel = [&](int i, int j, int) {
            const vec3<T> centre = airlight::texel_centre<T>(table, i, j);
            const AltitudeCosine<T> at = airlight::transmittance_parameters(air, vec2<T>(centre.x, centre.y),
                                                                            table.width, table.height);
            return airlight::transmittance<T, decltype(scene)>(air, at.altitude, at.mu,
                                                               airlight::no_surface<T>());
        };
        airlight::bake_table(table, texel, rows);
        return flat(table);
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        const GpuTable table = gpu.make_table(request.size);
        gpu.pass("transmittance", {&table});
        return numbers_of(table, 3);
    };
    return kind;
}

Kind extinction() {
    Kind kind{"extinction",
              "share of light that reaches space, plainly over altitude and angle; 0 behind the planet",
              {256, 256, 1},
              false,
              "extinction_uv",
              "share of light that passes from a point to space, 0 where the planet is in the way",
              "1",
              {"R", "G", "B"},
              false,
              {},
              {},
              {},
              {},
              {}};
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        Table<vec3<T>> table = airlight::make_table<vec3<T>>(request.size.width, request.size.height);
        const auto texel = [&](int i, int j, int) {
            const vec3<T> centre = airlight::texel_centre<T>(table, i, j);
            const AltitudeCosine<T> at =
                airlight::extinction_parameters(air, vec2<T>(centre.x, centre.y), table.width, table.height);
            return airlight::transmittance_to_space<T, decltype(scene)>(air, at.altitude, at.mu);
        };
        airlight::bake_table(table, texel, rows);
        return flat(table);
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        const GpuTable table = gpu.make_table(request.size);
        gpu.pass("extinction", {&table});
        return numbers_of(table, 3);
    };
    return kind;
}

}  // namespace

std::vector<Kind> transmittance_kinds() {
    return {transmittance(), extinction()};
}

}  // namespace bake_tables
