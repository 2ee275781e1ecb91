#pragma once

// The air in front of a camera in a grid of froxels: what it adds to a view and lets through, up to the
// distance of each slice.

#include <airlight/multiple_scattering.hpp>
#include <airlight/sky_view_mapping.hpp>

namespace airlight {

/// The view rays of a camera with a flat screen.
template <typename T>
struct CameraRays {
    vec3<T> centre;  ///< through the middle of the screen, a unit vector
    vec3<T> right;   ///< from there to its right edge: the tangent of half its width's angle long
    vec3<T> up;      ///< from there to its upper edge
};

/// The unit vector through a point of the screen.
///
/// Units:    screen [1], 0 left and 1 right, 0 below and 1 above; result a unit vector.
/// Domain:   every camera.
/// Accuracy: 8 roundoffs, and those of a sum that cancels.
/// Errors:   a camera that is flat has points without a direction: there it is the centre.
/// Source:   none.
template <typename T>
vec3<T> camera_direction(const CameraRays<T>& camera, const vec2<T>& screen) {
    const vec3<T> ray =
        camera.centre + (T(2) * screen.x - T(1)) * camera.right + (T(2) * screen.y - T(1)) * camera.up;
    const T length = glm::sqrt(dot_product(ray, ray));
    if (!(length > T(0))) {
        return camera.centre;
    }
    return ray / length;
}

/// The air between a camera and a froxel.
template <typename T>
struct FroxelAir {
    vec3<T> radiance;  ///< [1/sr] that it adds, per unit of solar irradiance above the air
    vec3<T> depth;     ///< [1] its optical depth: that can be filtered, transmittances cannot
};

/// The optical depth of what passes.
///
/// Units:    transmittance [1], a spectrum; result [1].
/// Domain:   transmittance in [0, 1].
/// Accuracy: a roundoff of 1, plus log's own.
/// Errors:   none; less than 1e-30 counts as that.
/// Source:   Beer's law.
template <typename T>
vec3<T> depth_of_transmittance(const vec3<T>& transmittance) {
    const vec3<T> least = vec3<T>(T(1e-30L), T(1e-30L), T(1e-30L));
    return -glm::log(glm::clamp(transmittance, least, vec3<T>(T(1), T(1), T(1))));
}

/// The direction of a froxel, lifted until the ray clears the ground as far as the slice.
///
///     mu >= -(h (2 R + h) + d^2) / (2 (R + h) d),   d at most the distance to the horizon
///
/// Behind the ground there is nothing to see, but its froxels are filtered together with those beside and
/// before it: so the light there is that of the ray that just gets so far.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and result unit vectors.
/// Domain:   every viewpoint; distance >= 0.
/// Accuracy: 8 roundoffs.
/// Errors:   none; a ray straight down, which has no side to be lifted to, stays.
/// Source:   law of cosines.
template <typename T>
vec3<T> direction_above_ground(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                               const vec3<T>& direction, T distance) {
    const T radius = atmosphere.ground_radius;
    const T above = glm::max(eye.altitude, T(0));
    const T to_horizon = horizon_distance(radius, above);
    const T reach = glm::max(glm::min(distance, to_horizon), T(1e-9L) * radius);
    const T touching = -(above * (T(2) * radius + above) + reach * reach) / (T(2) * (radius + above) * reach);
    const T passing = horizon_cosine(radius, above) + past_the_horizon<T>;
    const T least = distance < to_horizon ? touching : passing;
    const T mu = dot_product(eye.up, direction);
    const vec3<T> across = cross_of_unit_vectors(eye.up, direction);
    const T sine = glm::sqrt(dot_product(across, across));
    if (!(mu < least) || sine <= T(0)) {
        return direction;
    }
    const vec3<T> ahead = glm::cross(across, eye.up) / sine;
    return least * eye.up + safe_sqrt((T(1) - least) * (T(1) + least)) * ahead;
}

/// What a texel of the froxels holds.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; distance [L] of the
///           slice.
/// Domain:   that of all_scattering.
/// Accuracy: that of all_scattering; behind the ground that of direction_above_ground.
/// Errors:   none.
/// Source:   all_scattering.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename Visibility = AlwaysLit>
FroxelAir<T> froxel_texel(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                          const vec3<T>& to_sun, T distance,
                          const MultipleScattering& multiple_scattering = MultipleScattering{},
                          const Visibility& visibility = Visibility{}) {
    const vec3<T> lifted = direction_above_ground(atmosphere, eye, direction, distance);
    const Scattered<T> light =
        all_scattering<T, Scene>(atmosphere, eye, lifted, to_sun, distance, multiple_scattering, visibility);
    return FroxelAir<T>{light.radiance, depth_of_transmittance(light.transmittance)};
}

/// Hook: the froxels at texture coordinates, filtered over the screen and read at the centres of slices.
/// Without them there is no air.
struct NoFroxels {
    template <typename T>
    FroxelAir<T> operator()([[maybe_unused]] const vec3<T>& uvw) const {
        return FroxelAir<T>{vec3<T>(T(0), T(0), T(0)), vec3<T>(T(0), T(0), T(0))};
    }
};

/// The air up to a surface, from froxels.
///
/// Between two slices the optical depth grows evenly with the distance, and light is added as even air adds
/// it: in proportion to what a slice's share of the depth stops. In air that is the same along the ray that
/// is exact, however far apart the slices are.
///
///     L(d) = L_k + (L_{k+1} - L_k) (1 - exp(-w x)) / (1 - exp(-x)),   x the depth between the slices
///
/// Units:    screen [1], in [0, 1]; distances [L]; sizes in texels.
/// Domain:   every distance, beyond max_distance it counts as there; slices is slices_linear or
///           slices_quadratic; sizes >= 1, depth >= 2.
/// Accuracy: by size, docs/tables.md.
/// Errors:   none; a depth of 1 gives that slice.
/// Source:   integrated here.
template <typename T, typename FroxelTable = NoFroxels>
Scattered<T> froxel_light(const vec2<T>& screen, T distance, T max_distance, int slices, int width,
                          int height, int depth, const FroxelTable& froxel_table = FroxelTable{}) {
    const vec3<T> uvw = froxel_uvw(screen, distance, max_distance, slices, width, height, depth);
    const T last = glm::max(T(depth - 1), T(1));
    const T slice = glm::min(glm::floor(unit_from_texture(uvw.z, depth) * last), last - T(1));
    const T first_at = slice / last;
    const T second_at = (slice + T(1)) / last;
    const FroxelAir<T> first = froxel_table(vec3<T>(uvw.x, uvw.y, texture_from_unit(first_at, depth)));
    const FroxelAir<T> second = froxel_table(vec3<T>(uvw.x, uvw.y, texture_from_unit(second_at, depth)));

    const bool squares = slices == slices_quadratic;
    const T begin = squares ? first_at * first_at : first_at;
    const T end = squares ? second_at * second_at : second_at;
    const T weight = share_of(share_of(glm::min(distance, max_distance), max_distance) - begin, end - begin);
    const vec3<T> none = vec3<T>(T(0), T(0), T(0));
    const vec3<T> between = glm::max(second.depth - first.depth, none);
    const vec3<T> part = weight * between;
    const vec3<T> grown =
        weight * mean_passed(part, glm::exp(-part)) / mean_passed(between, glm::exp(-between));
    const vec3<T> radiance = first.radiance + (second.radiance - first.radiance) * grown;
    return Scattered<T>{glm::max(radiance, none), glm::exp(-(first.depth + part))};
}

}  // namespace airlight
