#pragma once

// CPU only. The table of the light of a habitat's strips, and the table as a hook.

#include <airlight/habitat_scattering.hpp>
#include <airlight/tables/table.hpp>

namespace airlight {

/// The place in a habitat that a texel of its tables stands for.
template <typename T, typename Texel>
vec3<T> habitat_of_texel(const HabitatAir<T>& air, const HabitatLights<T>& lights, const Table<Texel>& table,
                         int i, int j, int k) {
    const vec3<T> centre = texel_centre<T>(table, i, j, k);
    return habitat_from_unit(
        air, lights,
        vec3<T>(unit_from_texture(centre.x, table.width), unit_from_texture(centre.y, table.height),
                unit_from_texture(centre.z, table.depth)));
}

/// A table of a habitat at a place, filtered.
template <typename T>
vec3<T> sample_habitat(const HabitatAir<T>& air, const HabitatLights<T>& lights, const Table<vec3<T>>& table,
                       const vec3<T>& position) {
    return sample(table, habitat_texture(unit_from_habitat(air, lights, position), table.width, table.height,
                                         table.depth));
}

/// Fills the document's table, of the light itself: habitat_mean_radiance along the cylinder, from the wall
/// to the axis, from a strip to a sixth of a turn away.
///
/// Units:    texels as radiance, spectra; sizes in texels.
/// Domain:   that of habitat_mean_radiance; sizes >= 2.
/// Accuracy: that of habitat_mean_radiance; read between texels the unit test's.
/// Errors:   none.
/// Source:   Rama, the three-dimensional texture of 49 x 33 x 33 texels.
template <typename T, typename Scene = DefaultScene, typename Rows = OneAfterAnother>
Table<vec3<T>> bake_habitat_light(const HabitatAir<T>& air, const HabitatLights<T>& lights, int width = 49,
                                  int height = 33, int depth = 33, int pieces = 4,
                                  const Rows& rows = Rows{}) {
    Table<vec3<T>> table = make_table<vec3<T>>(width, height, depth);
    const auto texel = [&](int i, int j, int k) {
        return habitat_mean_radiance<T, Scene>(air, lights, habitat_of_texel(air, lights, table, i, j, k),
                                               pieces);
    };
    bake_table(table, texel, rows);
    return table;
}

/// Fills a table of habitat_mean_passed, which is smooth: for the same error a far smaller one.
///
/// Units:    texels [1], spectra; sizes in texels.
/// Domain:   that of habitat_mean_passed; sizes >= 2.
/// Accuracy: that of habitat_mean_passed; read between texels the unit test's.
/// Errors:   none.
/// Source:   docs/decisions/0017-local-lights-by-solid-angle.md.
template <typename T, typename Scene = DefaultScene, typename Rows = OneAfterAnother>
Table<vec3<T>> bake_habitat_passed(const HabitatAir<T>& air, const HabitatLights<T>& lights, int width = 49,
                                   int height = 33, int depth = 33, int pieces = 4,
                                   const Rows& rows = Rows{}) {
    Table<vec3<T>> table = make_table<vec3<T>>(width, height, depth);
    const auto texel = [&](int i, int j, int k) {
        return habitat_mean_passed<T, Scene>(air, lights, habitat_of_texel(air, lights, table, i, j, k),
                                             pieces);
    };
    bake_table(table, texel, rows);
    return table;
}

/// Hook: a habitat's light by the document's table, which has to outlive it.
template <typename T>
struct HabitatLightTable {
    const Table<vec3<T>>* table;

    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return sample_habitat(air, lights, *table, position);
    }
};

/// Hook: a habitat's light in closed form, times what passes by a table, which has to outlive it.
template <typename T>
struct HabitatPassedTable {
    const Table<vec3<T>>* table;

    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return habitat_bare_radiance(air, lights, position) * sample_habitat(air, lights, *table, position);
    }
};

}  // namespace airlight
