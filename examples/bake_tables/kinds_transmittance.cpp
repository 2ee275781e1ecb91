#include <airlight/table_mapping.hpp>
#include <airlight/transmittance.hpp>
#include <airlight/transmittance_table.hpp>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::AltitudeCosine;
using airlight::vec2;
using airlight::vec3;

/// One pass, one texture.
auto one_pass(const std::string& shader, int channels) {
    return [shader, channels](const Request& request, GpuBaker& gpu) {
        const GpuTable table = gpu.make_table(request.size);
        gpu.pass(shader, {&table});
        return numbers_of(table, channels);
    };
}

Kind slants() {
    Kind kind{
        "slants",
        "share of light that reaches space, as what a guess at Chapman's function lacks; ignores the ground",
        {64, 32, 1},
        "slant_uv",
        "by how much the air on a slanted path exceeds slant_guess: of molecules, of aerosol",
        "1",
        {"rayleigh", "mie"}};
    kind.may_be_negative = true;
    bake_each_alone(kind, [](auto scene, const auto& air, const auto& uvw, const support::TableSize& size) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        const AltitudeCosine<T> at =
            airlight::slant_parameters(air, vec2<T>(uvw.x, uvw.y), size.width, size.height);
        return airlight::slant_texel<T, decltype(scene)>(air, at.altitude, at.mu);
    });
    kind.on_gpu = one_pass("slants", 2);
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const double altitude = draws.altitude(air);
        const double mu = draws.sky_cosine(air, altitude);
        const auto slant_table = [&](const vec2<double>& uv) {
            const std::vector<double> read = look_up(vec3<double>(uv, 0.5));
            return vec2<double>(read[0], read[1]);
        };
        add(all,
            airlight::transmittance_from_slants<double, decltype(scene)>(
                air, altitude, mu, request.size.width, request.size.height, slant_table),
            airlight::transmittance<double, decltype(scene)>(air, altitude, mu,
                                                             airlight::no_surface<double>()));
    });
    kind.remark = "The errors are those of the transmittance, by `transmittance_from_slants`.";
    return kind;
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
    kind.on_gpu = one_pass("transmittance", 3);
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
    kind.on_gpu = one_pass("extinction", 3);
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
    return {slants(), transmittance(), extinction()};
}

}  // namespace bake_tables
