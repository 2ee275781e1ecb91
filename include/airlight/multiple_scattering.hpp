#pragma once

#include <airlight/diffuse_light.hpp>
#include <airlight/ray_legs.hpp>

namespace airlight {

/// The optical depth from which on a node is not seen [1].
template <typename T>
inline constexpr T unseen_depth = T(40);

/// The share of light that is left after a way; never less than exp(-unseen_depth), so that nodes of which
/// the eye sees none still weigh as much as each other.
///
/// Units:    depth [1]; result [1].
/// Shape:    depth and the result are spectra.
/// Domain:   every depth, below 0 it counts as 0.
/// Accuracy: that of exp.
/// Errors:   none.
/// Source:   Beer's law.
template <typename T>
vec3<T> seen_through(const vec3<T>& depth) {
    const T unseen = unseen_depth<T>;
    return glm::exp(-glm::clamp(depth, vec3<T>(T(0), T(0), T(0)), vec3<T>(unseen, unseen, unseen)));
}

/// The air between one node of a view ray and the eye.
///
/// Units:    altitude and along [L] of the node, along never negative; result [L].
/// Domain:   that of node_transmittance.
/// Accuracy: that of the columns.
/// Errors:   none; ignores the ground. Ozone below 0, a rounding, counts as 0: with it no more may pass than
///           without.
/// Source:   column_outwards.
template <typename T, typename Scene = DefaultScene>
inline Column<T> node_column_to_eye(const Atmosphere<T>& atmosphere, const LitRay<T>& ray,
                                    const Column<T>& offset, T outwards, T altitude, T along,
                                    const Density<T>& density) {
    const T radius = atmosphere.ground_radius + altitude;
    const LinePoint<T> on_ray =
        line_point(altitude, radius, T(1) / radius, along, ray.air.perigee_radius, ray.air.perigee_altitude);
    const Column<T> passed =
        column_sum(offset, -outwards, column_outwards<T, Scene>(ray.layers, on_ray, ray.shells, density));
    return Column<T>{passed.rayleigh, passed.mie, glm::max(passed.ozone, T(0))};
}

/// Light that had already been scattered, or reflected by the ground, and is scattered into a view ray.
///
/// Scene::nodes samples on each side of the ray's closest approach to the centre, lit by the sun or not. They
/// also add up what the ray loses, which is known: what they found too much or too little is put right. Ozone
/// stays out of that, for nodes do not follow the edges of its layer.
///
/// Units:    those of single_scattering; result [1/sr] per unit of solar irradiance above the air.
/// Domain:   that of single_scattering.
/// Accuracy: docs/multiple_scattering.md; exact in even light, L (1 - T), where the air absorbs nothing.
/// Errors:   none; no air on the ray gives 0. Where the eye sees none of the nodes, in air thousands of
///           optical depths thick, their mean.
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
    const RayLegs<T> legs = ray_legs<T, Scene>(atmosphere, ray);
    vec3<T> found = vec3<T>(T(0), T(0), T(0));  // what the ray loses but to ozone, by the nodes
    vec3<T> swept = vec3<T>(T(0), T(0), T(0));  // its optical depth, likewise
    for (int leg = 0; leg < 2; ++leg) {
        const bool climbs = leg == 1;
        if (climbs ? air.along + air.extent > T(0) : air.along < T(0)) {
            const T outwards = climbs ? T(1) : T(-1);
            const Column<T> offset = leg_offset(legs, climbs);
            const NodeMap<T> map = leg_map<T, Scene>(atmosphere, ray, legs, climbs);
            for (int j = 0; j < Scene::nodes; ++j) {
                const Node<T> node = node_at(map, gauss_position<T, Scene>(j));
                const T altitude = legs.turned.altitude + node.rise;
                const T radius = atmosphere.ground_radius + altitude;
                const T mu = glm::clamp(outwards * node.along / radius, T(-1), T(1));
                const T sun_height = ray.sun.perigee_height + outwards * node.along * ray.sun.cos_theta;
                const T mu_s = glm::clamp(sun_height / radius, T(-1), T(1));
                const Density<T> density = layer_density<T, Scene>(ray.layers, altitude);
                vec3<T> mie = vec3<T>(T(0), T(0), T(0));
                if constexpr (Scene::mie) {
                    mie = atmosphere.mie_scattering * density.mie;
                }
                const vec3<T> source = scattered_diffuse_light(
                    multiple_scattering(altitude, mu_s), atmosphere.rayleigh_scattering * density.rayleigh,
                    mie, mu, ray.sun.cos_theta, mu_s);
                const T share = gauss_weight<T, Scene>(j) * node.stretch;
                const Column<T> passed = node_column_to_eye<T, Scene>(atmosphere, ray, offset, outwards,
                                                                      altitude, node.along, density);
                radiance += share * source * seen_through(column_optical_depth<T, Scene>(atmosphere, passed));
                const vec3<T> taken = share * column_optical_depth<T, Scene>(
                                                  atmosphere, Column<T>{density.rayleigh, density.mie, T(0)});
                swept += taken;
                found += taken * seen_through(column_optical_depth<T, Scene>(
                                     atmosphere, Column<T>{passed.rayleigh, passed.mie, T(0)}));
            }
        }
    }
    const Column<T> whole = column_sum(leg_offset(legs, true), T(-1), legs.last.outwards);
    const vec3<T> depth =
        column_optical_depth<T, Scene>(atmosphere, Column<T>{whole.rayleigh, whole.mie, T(0)});
    return radiance * loss_ratios(found, swept, glm::max(depth, vec3<T>(T(0), T(0), T(0))));
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
