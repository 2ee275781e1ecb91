#pragma once

// CPU only. The table of light from all sides: a tiny one over altitude and the sun's height, from which come
// multiple scattering, the light off the ground that the air scatters, and the irradiance of surfaces by the
// sky.

#include <airlight/diffuse_table.hpp>
#include <airlight/gathered_light.hpp>
#include <airlight/tables/table.hpp>

namespace airlight {

/// A layer of a table whose layers are textures of their own, filtered as GL_LINEAR, GL_CLAMP_TO_EDGE.
template <typename Texel, typename T>
Texel sample_layer(const Table<Texel>& table, const vec2<T>& uv, int layer) {
    return detail::sample_slice(table, detail::axis_texels(uv.x, table.width),
                                detail::axis_texels(uv.y, table.height), layer);
}

/// Texels in layers, as a GL_TEXTURE_2D_ARRAY takes them: seven of DiffuseTexels, three of IrradianceTexels.
/// It is a hook: all_scattering(atmosphere, eye, direction, to_sun, distance, table).
template <typename T>
struct DiffuseTable {
    Atmosphere<T> atmosphere;
    Table<vec4<T>> texels;

    DiffuseLight<T> operator()(T altitude, T mu_s) const {
        const vec2<T> uv = diffuse_table_uv(atmosphere, altitude, mu_s, texels.width, texels.height);
        return unpacked_diffuse_light(DiffuseTexels<T>{
            sample_layer(texels, uv, 0), sample_layer(texels, uv, 1), sample_layer(texels, uv, 2),
            sample_layer(texels, uv, 3), sample_layer(texels, uv, 4), sample_layer(texels, uv, 5),
            sample_layer(texels, uv, 6)});
    }
};

/// Number of layers of a diffuse table.
inline constexpr int diffuse_table_layers = 10;

/// Irradiance by the sky and the ground at an altitude where the cosine between the sun and the vertical is
/// mu_s; sky_irradiance_on turns it to a surface.
template <typename T>
SkyIrradiance<T> sky_irradiance(const DiffuseTable<T>& table, T altitude, T mu_s) {
    const Table<vec4<T>>& texels = table.texels;
    const vec2<T> uv = diffuse_table_uv(table.atmosphere, altitude, mu_s, texels.width, texels.height);
    return unpacked_sky_irradiance(IrradianceTexels<T>{
        sample_layer(texels, uv, 7), sample_layer(texels, uv, 8), sample_layer(texels, uv, 9)});
}

/// The hook GroundIrradiance of a diffuse table.
template <typename T>
struct GroundSky {
    const DiffuseTable<T>* table;

    vec3<T> operator()(T mu_s) const {
        return sky_irradiance(*table, T(0), mu_s).down;
    }
};

namespace detail {

template <typename T>
void write_texel(Table<vec4<T>>& texels, int i, int j, const GatheredLight<T>& gathered) {
    const DiffuseTexels<T> light = packed_diffuse_light(gathered.light);
    const IrradianceTexels<T> sky = packed_sky_irradiance(gathered.irradiance);
    const vec4<T> layers[diffuse_table_layers] = {light.mean, light.vertical, light.slanted, light.across,
                                                  light.up,   light.down,     light.sunward, sky.down,
                                                  sky.up,     sky.sunward};
    for (int k = 0; k < diffuse_table_layers; ++k) {
        texels.texel(i, j, k) = layers[k];
    }
}

}  // namespace detail

/// Bakes a diffuse table: `orders` of scattering one by one, the rest as a geometric series.
///
/// Units:    as gathered_light.
/// Domain:   width and height >= 2; orders >= 1. 64 x 16 texels and 6 orders are a good choice.
/// Accuracy: docs/tables.md.
/// Errors:   none.
/// Source:   successive orders of scattering.
template <typename T, typename Scene = DefaultScene, typename Rows = OneAfterAnother>
DiffuseTable<T> bake_diffuse_table(const Atmosphere<T>& atmosphere, int width, int height, int orders,
                                   const Rows& rows = Rows{}) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto empty = make_table<vec4<T>>(width, height, diffuse_table_layers);
    std::vector<GatheredLight<T>> sum(count);
    std::vector<GatheredLight<T>> last(count);
    DiffuseTable<T> before{atmosphere, empty};  // the order before, as the hooks read it
    for (int order = 1; order <= orders; ++order) {
        std::vector<GatheredLight<T>> next(count);
        rows(height, [&](int j) {
            for (int i = 0; i < width; ++i) {
                const vec3<T> centre = texel_centre<T>(empty, i, j);
                const AltitudeCosine<T> point =
                    diffuse_table_parameters(atmosphere, vec2<T>(centre.x, centre.y), width, height);
                const std::size_t n = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                                      static_cast<std::size_t>(i);
                next[n] = gathered_light<T, Scene>(atmosphere, point.altitude, point.mu, order == 1, before,
                                                   GroundSky<T>{&before});
            }
        });
        for (std::size_t n = 0; n < count; ++n) {
            vec3<T> share(T(1), T(1), T(1));
            if (order == orders && order > 1) {
                for (int c = 0; c < 3; ++c) {
                    share[c] = gain_of_last_order(last[n].light.mean[c], next[n].light.mean[c]);
                }
            }
            sum[n] = order == 1 ? next[n] : sum_of_light(sum[n], share, next[n]);
        }
        last = next;
        const std::vector<GatheredLight<T>>& shown = order == orders ? sum : next;
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                detail::write_texel(before.texels, i, j,
                                    shown[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(i)]);
            }
        }
    }
    return before;
}

}  // namespace airlight
