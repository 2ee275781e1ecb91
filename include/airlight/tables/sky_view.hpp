#pragma once

// CPU only. The sky around one eye, ready to be looked up.

#include <airlight/sky_view_table.hpp>
#include <airlight/tables/table.hpp>

namespace airlight {

/// Fills the sky for an eye at `altitude` with the sun at mu_s, without ground or sun; scattered once, and
/// more often as the hook says. An odd height counts as one more.
///
/// Units:    altitude [L]; mu_s [1], cosine between the sun and the vertical; texels [1/sr] per unit of solar
///           irradiance above the air, spectra; width and height in texels.
/// Domain:   that of sky_view_ray; width and height >= 1.
/// Accuracy: that of sky_view_texel; read between texels by size, docs/tables.md.
/// Errors:   none.
/// Source:   sky_view_texel.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename Rows = OneAfterAnother>
Table<vec3<T>> bake_sky_view(const Atmosphere<T>& atmosphere, T altitude, T mu_s, int width = 192,
                             int height = 108,
                             const MultipleScattering& multiple_scattering = MultipleScattering{},
                             const Rows& rows = Rows{}) {
    Table<vec3<T>> table = make_table<vec3<T>>(width, height + height % 2);
    const auto texel = [&](int i, int j, int) {
        const vec3<T> centre = texel_centre<T>(table, i, j);
        const SkyDirection<T> seen = sky_view_parameters(
            atmosphere.ground_radius, altitude, vec2<T>(centre.x, centre.y), table.width, table.height);
        return sky_view_texel<T, Scene>(atmosphere, altitude, mu_s, seen, multiple_scattering);
    };
    bake_table(table, texel, rows);
    return table;
}

/// Radiance of the sky in a direction, from the table of this eye and sun.
///
/// Units:    altitude of the eye [L]; direction and to_sun unit vectors; result [1/sr] per unit of solar
///           irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   the eye and the sun for which the table was baked.
/// Accuracy: by size, docs/tables.md.
/// Errors:   none; an empty table gives 0.
/// Source:   sky_view_place.
template <typename T>
vec3<T> sky_view_radiance(const Table<vec3<T>>& table, const Atmosphere<T>& atmosphere,
                          const Viewpoint<T>& eye, const vec3<T>& direction, const vec3<T>& to_sun) {
    return sample(table, sky_view_place(atmosphere, eye, direction, to_sun, table.width, table.height));
}

}  // namespace airlight
