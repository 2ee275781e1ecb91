#pragma once

// CPU only. Tables of what passes to space, ready as hooks for what asks for TransmittanceToSpace.

#include <airlight/tables/table.hpp>
#include <airlight/transmittance_table.hpp>

namespace airlight {

/// Fills a table of slants: two numbers a texel, see slant_texel; for linear filtering.
///
/// Units:    texels [1]; width and height in texels.
/// Domain:   that of slant_texel; width and height >= 1.
/// Accuracy: that of slant_texel; read between texels that of column_from_slants.
/// Errors:   none.
/// Source:   slant_texel.
template <typename T, typename Scene = DefaultScene, typename Rows = OneAfterAnother>
Table<vec2<T>> bake_slants(const Atmosphere<T>& atmosphere, int width = 64, int height = 32,
                           const Rows& rows = Rows{}) {
    Table<vec2<T>> table = make_table<vec2<T>>(width, height);
    const auto texel = [&](int i, int j, int) {
        const vec3<T> centre = texel_centre<T>(table, i, j);
        const AltitudeCosine<T> at =
            slant_parameters(atmosphere, vec2<T>(centre.x, centre.y), table.width, table.height);
        return slant_texel<T, Scene>(atmosphere, at.altitude, at.mu);
    };
    bake_table(table, texel, rows);
    return table;
}

/// Hook: what passes to space by a table of slants, which has to outlive it.
template <typename T, typename Scene = DefaultScene>
struct SlantTransmittance {
    const Table<vec2<T>>* slants;

    vec3<T> operator()(const Atmosphere<T>& atmosphere, T altitude, T mu) const {
        const auto look_up = [this](const vec2<T>& uv) { return sample(*slants, uv); };
        return transmittance_from_slants<T, Scene>(atmosphere, altitude, mu, slants->width, slants->height,
                                                   look_up);
    }
};

/// Fills a table of the transmittances themselves over altitude and angle, 0 behind the planet: simple, and
/// off by what a share of a texel makes of a number that changes a thousandfold.
///
/// Units:    texels [1], spectra; width and height in texels.
/// Domain:   that of transmittance_to_space; width and height >= 1.
/// Accuracy: that of transmittance_to_space; read between texels by size, docs/tables.md.
/// Errors:   none.
/// Source:   transmittance_to_space, extinction_uv.
template <typename T, typename Scene = DefaultScene, typename Rows = OneAfterAnother>
Table<vec3<T>> bake_extinction(const Atmosphere<T>& atmosphere, int width = 256, int height = 256,
                               const Rows& rows = Rows{}) {
    Table<vec3<T>> table = make_table<vec3<T>>(width, height);
    const auto texel = [&](int i, int j, int) {
        const vec3<T> centre = texel_centre<T>(table, i, j);
        const AltitudeCosine<T> at =
            extinction_parameters(atmosphere, vec2<T>(centre.x, centre.y), table.width, table.height);
        return transmittance_to_space<T, Scene>(atmosphere, at.altitude, at.mu);
    };
    bake_table(table, texel, rows);
    return table;
}

/// Hook: what passes to space by a table of extinctions, which has to outlive it.
template <typename T>
struct ExtinctionTransmittance {
    const Table<vec3<T>>* extinction;

    vec3<T> operator()(const Atmosphere<T>& atmosphere, T altitude, T mu) const {
        return sample(*extinction,
                      extinction_uv(atmosphere, altitude, mu, extinction->width, extinction->height));
    }
};

}  // namespace airlight
