#pragma once

// CPU only. The air in front of one camera, ready to be looked up.

#include <airlight/froxel_table.hpp>
#include <airlight/tables/table.hpp>

namespace airlight {

/// The froxels of one camera: what the air adds and its optical depth, up to each slice.
template <typename T>
struct Froxels {
    Table<vec3<T>> radiance;
    Table<vec3<T>> depth;
    T max_distance;  ///< [L] of the last slice
    int slices;      ///< slices_linear or slices_quadratic
};

/// How fine.
struct FroxelSize {
    int width = 32;
    int height = 32;
    int depth = 32;
    int slices = slices_quadratic;
};

/// Fills froxels: light scattered once, and more often as the hook says.
///
/// Units:    lengths in the atmosphere's unit [L]; to_sun a unit vector; sizes in texels; texels those of
///           FroxelAir.
/// Domain:   that of all_scattering; max_distance > 0; width and height >= 1, depth >= 2; size.slices is
///           slices_linear or slices_quadratic.
/// Accuracy: that of froxel_texel; read between texels by size, docs/tables.md.
/// Errors:   none.
/// Source:   froxel_texel.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename Rows = OneAfterAnother>
Froxels<T> bake_froxels(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const CameraRays<T>& camera,
                        const vec3<T>& to_sun, T max_distance, const FroxelSize& size = FroxelSize{},
                        const MultipleScattering& multiple_scattering = MultipleScattering{},
                        const Rows& rows = Rows{}) {
    Froxels<T> froxels = {make_table<vec3<T>>(size.width, size.height, size.depth),
                          make_table<vec3<T>>(size.width, size.height, size.depth), max_distance,
                          size.slices};
    const auto texel = [&](int i, int j, int k) {
        const FroxelPoint<T> at = froxel_parameters(texel_centre<T>(froxels.radiance, i, j, k), max_distance,
                                                    size.slices, size.width, size.height, size.depth);
        const FroxelAir<T> air = froxel_texel<T, Scene>(atmosphere, eye, camera_direction(camera, at.screen),
                                                        to_sun, at.distance, multiple_scattering);
        froxels.depth.texel(i, j, k) = air.depth;
        return air.radiance;
    };
    bake_table(froxels.radiance, texel, rows);
    return froxels;
}

/// The air up to a surface at a point of the screen.
///
/// Units:    screen [1], in [0, 1]; distance [L]; result per unit of solar irradiance above the air, radiance
///           [1/sr].
/// Domain:   froxels of bake_froxels; every distance, beyond max_distance it counts as there.
/// Accuracy: by size, docs/tables.md.
/// Errors:   none; empty tables give no air.
/// Source:   froxel_light.
template <typename T>
Scattered<T> froxel_light_of(const Froxels<T>& froxels, const vec2<T>& screen, T distance) {
    const auto look_up = [&](const vec3<T>& uvw) {
        return FroxelAir<T>{sample(froxels.radiance, uvw), sample(froxels.depth, uvw)};
    };
    return froxel_light(screen, distance, froxels.max_distance, froxels.slices, froxels.radiance.width,
                        froxels.radiance.height, froxels.radiance.depth, look_up);
}

}  // namespace airlight
