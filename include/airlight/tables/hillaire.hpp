#pragma once

// CPU only. Hillaire's table of multiple scattering, ready to be looked up.

#include <airlight/diffuse_light.hpp>
#include <airlight/hillaire_table.hpp>
#include <airlight/table_storage.hpp>
#include <airlight/tables/table.hpp>

namespace airlight {

/// How much work a texel is, see hillaire_texel.
struct HillaireEffort {
    int zeniths = 8;
    int azimuths = 4;  ///< on one side of the sun
    int steps = 20;
};

/// Fills Hillaire's table: x the sun, y the altitude, see altitude_sun_uv.
///
/// Units:    texels [1/sr] per unit of solar irradiance above the air, spectra; width and height in texels.
/// Domain:   that of hillaire_texel; width, height and all of effort >= 1.
/// Accuracy: that of hillaire_texel; read between texels by size, docs/tables.md.
/// Errors:   none.
/// Source:   hillaire_texel.
template <typename T, typename Scene = DefaultScene, typename Rows = OneAfterAnother>
Table<vec3<T>> bake_hillaire(const Atmosphere<T>& atmosphere, int width = 32, int height = 32,
                             const HillaireEffort& effort = HillaireEffort{}, const Rows& rows = Rows{}) {
    Table<vec3<T>> table = make_table<vec3<T>>(width, height);
    const auto texel = [&](int i, int j, int) {
        const vec3<T> centre = texel_centre<T>(table, i, j);
        const AltitudeCosine<T> at =
            altitude_sun_parameters(atmosphere, vec2<T>(centre.x, centre.y), table.width, table.height);
        return hillaire_texel<T, Scene>(atmosphere, at.altitude, at.mu, effort.zeniths, effort.azimuths,
                                        effort.steps);
    };
    bake_table(table, texel, rows);
    return table;
}

/// Hook: all orders from the second on as light that comes evenly from all sides. Atmosphere and table have
/// to outlive it.
template <typename T>
struct HillaireLight {
    const Atmosphere<T>* atmosphere;
    const Table<vec3<T>>* table;
    /// The texels are stored_light: two to three times closer in twilight, and fit for half.
    bool roots = false;

    DiffuseLight<T> operator()(T altitude, T mu_s) const {
        const vec3<T> texels =
            sample(*table, altitude_sun_uv(*atmosphere, altitude, mu_s, table->width, table->height));
        return even_light(roots ? light_from_stored(texels) : texels);
    }
};

}  // namespace airlight
