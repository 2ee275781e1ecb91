#pragma once

// CPU only. Hillaire's table of multiple scattering, ready to be looked up.

#include <airlight/hillaire_table.hpp>
#include <airlight/tables/table.hpp>

namespace airlight {

/// How much work a texel is, see hillaire_texel.
struct HillaireEffort {
    int zeniths = 8;
    int azimuths = 4;  ///< on one side of the sun
    int steps = 20;
};

/// x the sun, y the altitude, see altitude_sun_uv.
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

/// The table at a place, all orders from the second on: times the scattering coefficient there, it is their
/// source. The table has to outlive it.
template <typename T>
struct HillaireLight {
    const Table<vec3<T>>* table;

    vec3<T> operator()(const Atmosphere<T>& atmosphere, T altitude, T mu_s) const {
        return sample(*table, altitude_sun_uv(atmosphere, altitude, mu_s, table->width, table->height));
    }
};

}  // namespace airlight
