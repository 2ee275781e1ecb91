#pragma once

// CPU only. Tables of the light of a habitat's strips and of its indirect light, and the tables as hooks.

#include <airlight/habitat_indirect.hpp>
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

/// The indirect light of a habitat, in the coordinates of its other tables.
template <typename T>
struct HabitatIndirectTables {
    Table<vec3<T>> mean;        ///< HabitatIndirect::mean
    Table<vec3<T>> irradiance;  ///< HabitatIndirect::irradiance
};

/// Hook: a habitat's mean radiance, straight from the strips by another hook and indirect by a table.
template <typename T, typename StraightLight>
struct HabitatWithIndirect {
    const Table<vec3<T>>* mean;
    StraightLight straight_light;

    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return straight_light(air, lights, position) + sample_habitat(air, lights, *mean, position);
    }
};

/// Hook: the indirect irradiance of a habitat's wall by a table.
template <typename T>
struct HabitatIrradianceTable {
    const HabitatAir<T>* air;
    const HabitatLights<T>* lights;
    const Table<vec3<T>>* irradiance;

    vec3<T> operator()(const vec3<T>& position) const {
        return sample_habitat(*air, *lights, *irradiance, position);
    }
};

/// Fills the tables of indirect light, a bounce at a time: what the walls and the air scatter of the strips'
/// light, then of that, and so on.
///
/// Units:    albedo of the walls [1]; texels as radiance, irradiance times sr; sizes in texels.
/// Shape:    albedo is a spectrum.
/// Domain:   that of gathered_habitat_light; sizes >= 2; bounces >= 0; straight_light gives the strips' own.
/// Accuracy: that of gathered_habitat_light in each bounce.
/// Errors:   none; without bounces no light.
/// Source:   Rama, whose indirect light has two bounces.
template <typename T, typename Scene = DefaultScene, typename StraightLight = BareHabitatLight,
          typename Rows = OneAfterAnother>
HabitatIndirectTables<T> bake_habitat_indirect(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                                               const vec3<T>& albedo, int bounces = 2, int width = 25,
                                               int height = 9, int depth = 9, int directions = 128,
                                               const StraightLight& straight_light = StraightLight{},
                                               const Rows& rows = Rows{}) {
    HabitatIndirectTables<T> last{make_table<vec3<T>>(width, height, depth),
                                  make_table<vec3<T>>(width, height, depth)};
    for (int bounce = 0; bounce < bounces; ++bounce) {
        HabitatIndirectTables<T> next = last;
        const HabitatWithIndirect<T, StraightLight> light{&last.mean, straight_light};
        const HabitatIrradianceTable<T> irradiance{&air, &lights, &last.irradiance};
        const auto texel = [&](int i, int j, int k) {
            const HabitatIndirect<T> gathered = gathered_habitat_light<T, Scene>(
                air, lights, albedo, habitat_of_texel(air, lights, last.mean, i, j, k), directions,
                AlwaysSeen{}, light, irradiance);
            next.irradiance.texel(i, j, k) = gathered.irradiance;
            return gathered.mean;
        };
        bake_table(next.mean, texel, rows);
        last = next;
    }
    return last;
}

}  // namespace airlight
