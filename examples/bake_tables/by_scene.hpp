#pragma once

// From a preset, known when the program runs, to the scene that tables are compiled for.

#include <airlight/tables/table.hpp>
#include <vector>

#include "kinds.hpp"
#include "places.hpp"

namespace bake_tables {

/// Calls bake(scene, atmosphere in T).
template <typename T, typename Bake>
auto by_scene(const support::Preset& preset, const Bake& bake) {
    const airlight::Atmosphere<T> air = support::converted<T>(preset.air);
    return support::with_ozone(preset.ozone, [&](auto scene) { return bake(scene, air); });
}

/// Gives a kind its bakes on the CPU: bake(scene, atmosphere, request, rows), for float and double.
template <typename Bake>
void bake_on_cpu(Kind& kind, const Bake& bake) {
    kind.on_cpu = [bake](const Request& request, const support::Rows& rows) {
        return by_scene<float>(request.preset,
                               [&](auto scene, const auto& air) { return bake(scene, air, request, rows); });
    };
    kind.in_double = [bake](const Request& request, const support::Rows& rows) {
        return by_scene<double>(request.preset,
                                [&](auto scene, const auto& air) { return bake(scene, air, request, rows); });
    };
}

/// The scalar of an atmosphere.
template <typename Air>
using scalar_of = decltype(Air::mie_g);

/// The same for a table whose texels know nothing of each other: texel(scene, atmosphere, uvw, size).
template <typename TexelAt>
void bake_each_alone(Kind& kind, const TexelAt& texel) {
    bake_on_cpu(kind, [texel](auto scene, const auto& air, const Request& request,
                              const support::Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        using Texel = decltype(texel(scene, air, airlight::vec3<T>(), request.size));
        auto table = airlight::make_table<Texel>(request.size.width, request.size.height, request.size.depth);
        airlight::bake_table(
            table,
            [&](int i, int j, int k) {
                return texel(scene, air, airlight::texel_centre<T>(table, i, j, k), request.size);
            },
            rows);
        return support::numbers_of(table);
    });
}

/// Gives a kind its comparison: compare(scene, atmosphere, request, look_up, draws, out) for each place.
template <typename Compare>
void compare_each(Kind& kind, const Compare& compare) {
    kind.compare = [compare](const Request& request, const LookUp& look_up, const PlaceChoice& choice) {
        Compared all;
        by_scene<double>(request.preset, [&](auto scene, const auto& air) {
            for (int n = 0; n < choice.count; ++n) {
                Draws draws(n, choice.sun_elevation);
                compare(scene, air, request, look_up, draws, all);
            }
        });
        return all;
    };
}

/// One number a channel: read and exact.
inline void add(Compared& all, const std::vector<double>& read, const airlight::vec3<double>& exact) {
    for (int c = 0; c < 3; ++c) {
        all.read.push_back(read[std::size_t(c)]);
        all.exact.push_back(exact[c]);
    }
}
inline void add(Compared& all, const airlight::vec3<double>& read, const airlight::vec3<double>& exact) {
    add(all, std::vector<double>{read.x, read.y, read.z}, exact);
}

}  // namespace bake_tables
