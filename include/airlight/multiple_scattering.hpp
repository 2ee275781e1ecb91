#pragma once

#include <airlight/diffuse_light.hpp>
#include <airlight/single_scattering.hpp>

namespace airlight {

/// Light from all sides that one node of a ray scatters towards the eye, dimmed on its way there.
///
/// Units:    those of node_radiance; result [1/(L sr)] per unit of solar irradiance above the air.
/// Domain:   that of node_radiance; light is that at the node.
/// Accuracy: that of the columns.
/// Errors:   none; ignores the ground.
/// Source:   Beer's law, scattered_diffuse_light.
template <typename T, typename Scene = DefaultScene>
inline vec3<T> node_diffuse_radiance(const Atmosphere<T>& atmosphere, const LitRay<T>& ray,
                                     const DiffuseLight<T>& light, const Column<T>& offset, T outwards,
                                     T altitude, T along, T mu_s, const Density<T>& density) {
    const T radius = atmosphere.ground_radius + altitude;
    const LinePoint<T> on_ray =
        line_point(altitude, radius, T(1) / radius, along, ray.air.perigee_radius, ray.air.perigee_altitude);
    const Column<T> beyond = column_outwards<T, Scene>(ray.layers, on_ray, ray.shells, density);
    const vec3<T> depth = column_optical_depth<T, Scene>(atmosphere, column_sum(offset, -outwards, beyond));
    vec3<T> mie = vec3<T>(T(0), T(0), T(0));
    if constexpr (Scene::mie) {
        mie = atmosphere.mie_scattering * density.mie;
    }
    const T mu = glm::clamp(outwards * along / radius, T(-1), T(1));
    const vec3<T> source = scattered_diffuse_light(light, atmosphere.rayleigh_scattering * density.rayleigh,
                                                   mie, mu, ray.sun.cos_theta, mu_s);
    return source * glm::exp(-glm::max(depth, vec3<T>(T(0), T(0), T(0))));
}

/// Light that had already been scattered, or reflected by the ground, and is scattered into a view ray.
///
/// Scene::nodes samples on each side of the ray's closest approach to the centre, lit by the sun or not.
///
/// Units:    those of single_scattering; result [1/sr] per unit of solar irradiance above the air.
/// Domain:   that of single_scattering.
/// Accuracy: docs/multiple_scattering.md.
/// Errors:   none; no air on the ray gives 0.
/// Source:   the node method of single_scattering, docs/theory/nodes.md.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight>
vec3<T> diffuse_scattering(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction,
                           const vec3<T>& to_sun, T distance,
                           const MultipleScattering& multiple_scattering = MultipleScattering{}) {
    vec3<T> radiance = vec3<T>(T(0), T(0), T(0));
    const AirRay<T> air = air_ray(atmosphere, eye, direction, distance);
    if (!air.in_air) {
        return radiance;
    }
    const LitRay<T> ray = lit_ray<T, Scene>(atmosphere, air, eye, direction, to_sun);
    const NodeFit<T> fit = node_fit<T, Scene>();
    const bool falls = air.along < T(0);
    const bool climbs = air.along + air.extent > T(0);
    RayPoint<T> here = ray_point<T, Scene>(atmosphere, ray, T(0));
    Column<T> offset = column_sum(Column<T>{T(0), T(0), T(0)}, T(-1), here.outwards);
    T outwards = T(-1);
    for (int leg = 0; leg < 2; ++leg) {
        if (leg == 0 ? falls : climbs) {
            const T begin = leg == 1 && falls ? -air.along : T(0);
            const T end = leg == 0 && climbs ? -air.along : air.extent;
            if (leg == 1) {
                if (falls) {
                    here = ray_point<T, Scene>(atmosphere, ray, begin);
                }
                offset = column_sum(offset, T(2), here.outwards);
                outwards = T(1);
            }
            RayPoint<T> low = here;
            here = ray_point<T, Scene>(atmosphere, ray, end);
            RayPoint<T> high = here;
            if (leg == 0) {
                high = low;
                low = here;
            }
            const T low_along = glm::abs(air.along + (leg == 0 ? end : begin));
            const T low_radius = atmosphere.ground_radius + low.altitude;
            const T high_radius = atmosphere.ground_radius + high.altitude;
            const T extent = glm::max(end - begin, T(0));
            const T rise = extent * (T(2) * low_along + extent) / (low_radius + high_radius);
            const T height = glm::max(ray.layers.rayleigh_height, T(1e-6L) * rise);
            const T depth =
                guiding_depth<T, Scene>(atmosphere, column_sum(low.outwards, T(-1), high.outwards));
            const NodeMap<T> map =
                node_map(fit, low_radius, low_along, high_radius, rise, height, -outwards * fit.view * depth);
            for (int j = 0; j < Scene::nodes; ++j) {
                const Node<T> node = node_at(map, gauss_position<T, Scene>(j));
                const T altitude = low.altitude + node.rise;
                const T sun_height = ray.sun.perigee_height + outwards * node.along * ray.sun.cos_theta;
                const T mu_s = glm::clamp(sun_height / (atmosphere.ground_radius + altitude), T(-1), T(1));
                radiance += gauss_weight<T, Scene>(j) * node.stretch *
                            node_diffuse_radiance<T, Scene>(
                                atmosphere, ray, multiple_scattering(altitude, mu_s), offset, outwards,
                                altitude, node.along, mu_s, layer_density<T, Scene>(ray.layers, altitude));
            }
        }
    }
    return radiance;
}

/// Sunlight scattered into a view ray, however often.
///
/// What was scattered more than once comes from a hook that knows the light from all sides at a point: a
/// table of DiffuseLight, or any other.
///
/// Units:    those of single_scattering.
/// Domain:   that of single_scattering.
/// Accuracy: docs/multiple_scattering.md.
/// Errors:   none; no air on the ray gives radiance 0 and transmittance 1.
/// Source:   single_scattering, diffuse_scattering.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename Visibility = AlwaysLit>
Scattered<T> all_scattering(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                            const vec3<T>& direction, const vec3<T>& to_sun, T distance,
                            const MultipleScattering& multiple_scattering = MultipleScattering{},
                            const Visibility& visibility = Visibility{}) {
    const Scattered<T> once =
        single_scattering<T, Scene>(atmosphere, eye, direction, to_sun, distance, visibility);
    const vec3<T> again =
        diffuse_scattering<T, Scene>(atmosphere, eye, direction, to_sun, distance, multiple_scattering);
    return Scattered<T>{once.radiance + again, once.transmittance};
}

/// Light that had already been scattered, or reflected by the ground, and is scattered into a view ray, by
/// `steps` equal steps through the air.
///
/// Units:    those of diffuse_scattering.
/// Domain:   that of single_scattering_marched.
/// Accuracy: that of single_scattering_marched.
/// Errors:   none; no air on the ray gives 0.
/// Source:   the integral of diffuse_scattering, by the midpoint rule.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight>
vec3<T> diffuse_scattering_marched(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                                   const vec3<T>& direction, const vec3<T>& to_sun, T distance, int steps,
                                   const MultipleScattering& multiple_scattering = MultipleScattering{}) {
    const T radius = atmosphere.ground_radius;
    vec3<T> radiance = vec3<T>(T(0), T(0), T(0));
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, distance);
    if (!ray.in_air) {
        return radiance;
    }
    const T step_length = ray.extent / glm::max(T(steps), T(1));
    const SunOverLine<T> sun = sun_over_line(radius, eye, direction, to_sun);
    Column<T> passed = Column<T>{T(0), T(0), T(0)};
    for (int i = 0; i < steps; ++i) {
        const T t = (T(i) + T(0.5)) * step_length;
        const T altitude = glm::max(altitude_along_ray(radius, ray.altitude, ray.along, t), T(0));
        const T inverse_radius = T(1) / (radius + altitude);
        const T mu_s =
            glm::clamp((sun.perigee_height + (ray.along + t) * sun.cos_theta) * inverse_radius, T(-1), T(1));
        const T mu = glm::clamp((ray.along + t) * inverse_radius, T(-1), T(1));
        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        const Column<T> in_step = Column<T>{density.rayleigh, density.mie, density.ozone};
        const Column<T> seen_through = column_sum(passed, T(0.5) * step_length, in_step);
        vec3<T> mie = vec3<T>(T(0), T(0), T(0));
        if constexpr (Scene::mie) {
            mie = atmosphere.mie_scattering * density.mie;
        }
        const vec3<T> source = scattered_diffuse_light(multiple_scattering(altitude, mu_s),
                                                       atmosphere.rayleigh_scattering * density.rayleigh, mie,
                                                       mu, sun.cos_theta, mu_s);
        radiance +=
            source * glm::exp(-column_optical_depth<T, Scene>(atmosphere, seen_through)) * step_length;
        passed = column_sum(passed, step_length, in_step);
    }
    return radiance;
}

}  // namespace airlight
