#pragma once

#include <airlight/gauss.hpp>
#include <airlight/node_map.hpp>
#include <airlight/phase.hpp>
#include <airlight/planet_shadow.hpp>
#include <airlight/sun_column.hpp>
#include <airlight/transmittance.hpp>

namespace airlight {

/// What the air adds to a view ray, and the share it lets through.
template <typename T>
struct Scattered {
    vec3<T> radiance;       ///< [1/sr] towards the eye, per unit of solar irradiance above the air
    vec3<T> transmittance;  ///< [1] of the whole ray, in [0, 1]
};

/// A view ray in the air with all that its nodes share.
template <typename T>
struct LitRay {
    AirRay<T> air;            ///< its stretch in the air
    SunOverLine<T> sun;       ///< the sun over it
    Layers<T> layers;         ///< of the atmosphere
    Shells<T> shells;         ///< [L] its shells_along
    vec3<T> rayleigh_source;  ///< [1/(L sr)] scattered towards the eye by molecules of density 1
    vec3<T> mie_source;       ///< [1/(L sr)] the same by the aerosol
};

/// A view ray made ready for its nodes.
///
/// Units:    those of single_scattering.
/// Domain:   that of single_scattering; air is air_ray's.
/// Accuracy: that of its parts.
/// Errors:   none.
/// Source:   sun_over_line, layers_of, rayleigh_phase, mie_phase.
template <typename T, typename Scene = DefaultScene>
inline LitRay<T> lit_ray(const Atmosphere<T>& atmosphere, const AirRay<T>& air, const Viewpoint<T>& eye,
                         const vec3<T>& direction, const vec3<T>& to_sun) {
    const SunOverLine<T> sun = sun_over_line(atmosphere.ground_radius, eye, direction, to_sun);
    const Layers<T> layers = layers_of<T, Scene>(atmosphere);
    const Shells<T> shells =
        shells_along<T, Scene>(layers.ozone, atmosphere.ground_radius, air.perigee_altitude);
    const vec3<T> rayleigh_source = atmosphere.rayleigh_scattering * rayleigh_phase(sun.cos_theta);
    vec3<T> mie_source = vec3<T>(T(0), T(0), T(0));
    if constexpr (Scene::mie) {
        mie_source = atmosphere.mie_scattering * mie_phase<T, Scene>(sun.cos_theta, atmosphere.mie_g);
    }
    return LitRay<T>{air, sun, layers, shells, rayleigh_source, mie_source};
}

/// A point of a view ray and the air there.
template <typename T>
struct RayPoint {
    T altitude;          ///< [L]
    Density<T> density;  ///< [1] of molecules and aerosol
    Column<T> outwards;  ///< [L] of air from here on, away from the closest approach
};

/// The point of a view ray at a distance from the start of its stretch in the air.
///
/// Units:    t [L].
/// Domain:   t from 0 to ray.air.extent.
/// Accuracy: that of altitude_along_ray and column_outwards.
/// Errors:   none.
/// Source:   altitude_along_ray, column_outwards.
template <typename T, typename Scene = DefaultScene>
RayPoint<T> ray_point(const Atmosphere<T>& atmosphere, const LitRay<T>& ray, T t) {
    const T altitude =
        glm::max(altitude_along_ray(atmosphere.ground_radius, ray.air.altitude, ray.air.along, t), T(0));
    const T radius = atmosphere.ground_radius + altitude;
    const Density<T> density = layer_density<T, Scene>(ray.layers, altitude);
    const LinePoint<T> point = line_point(altitude, radius, T(1) / radius, glm::abs(ray.air.along + t),
                                          ray.air.perigee_radius, ray.air.perigee_altitude);
    return RayPoint<T>{altitude, density, column_outwards<T, Scene>(ray.layers, point, ray.shells, density)};
}

/// The optical depth that the nodes follow: mostly red's, which is what is left of light that has come far.
///
/// Units:    column [L]; result [1].
/// Domain:   every column.
/// Accuracy: 6 ulp.
/// Errors:   none.
/// Source:   chosen: red is what is left of light that has come far, green is most of the luminance.
template <typename T, typename Scene = DefaultScene>
inline T guiding_depth(const Atmosphere<T>& atmosphere, const Column<T>& column) {
    const vec3<T> depth = column_optical_depth<T, Scene>(atmosphere, column);
    return T(0.75) * depth.x + T(0.25) * depth.y;
}

/// The node map of one piece of a view ray: how strongly light is lost towards the sun and towards the
/// eye decides which end the nodes crowd at.
///
/// Units:    extent [L] of the piece; low_along [L] of its low end from the closest approach.
/// Domain:   low and high are the piece's ends; outwards is 1 where the ray climbs, -1 where it falls.
/// Accuracy: none, every map is exact.
/// Errors:   none.
/// Source:   docs/theory/nodes.md.
template <typename T, typename Scene = DefaultScene>
NodeMap<T> piece_map(const Atmosphere<T>& atmosphere, const LitRay<T>& ray, const RayPoint<T>& low,
                     const RayPoint<T>& high, T low_along, T extent, T outwards) {
    const NodeFit<T> fit = node_fit<T, Scene>();
    const T low_radius = atmosphere.ground_radius + low.altitude;
    const T high_radius = atmosphere.ground_radius + high.altitude;
    const T rise = extent * (T(2) * low_along + extent) / (low_radius + high_radius);
    const T height = glm::max(ray.layers.rayleigh_height, T(1e-6L) * rise);

    const T sun_height = ray.sun.perigee_height + outwards * low_along * ray.sun.cos_theta;
    const LinePoint<T> to_sun = line_towards_sun(low.altitude, low_radius, T(1) / low_radius, sun_height);
    const Column<T> sunlit =
        exponentials_to_sun<T, Scene>(ray.layers, to_sun, sun_height < T(0), low.density);
    const T sun_depth = glm::min(guiding_depth<T, Scene>(atmosphere, sunlit), T(1e4L));
    const T view_depth = guiding_depth<T, Scene>(atmosphere, column_sum(low.outwards, T(-1), high.outwards));
    const T pulled = fit.sun * sun_depth * rise / (rise + height) - outwards * fit.view * view_depth;
    return node_map(fit, low_radius, low_along, high_radius, rise, height, pulled);
}

/// The share of sunlight that is left after its way to one node of a view ray and from there to the eye.
///
/// Units:    altitude and along [L] of the node, along never negative; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   a node of the ray with its density; the column from the eye is offset - outwards times the
///           node's.
/// Accuracy: that of the columns.
/// Errors:   none; ignores the ground.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
[[gnu::always_inline]] inline vec3<T> node_transmittance(const Atmosphere<T>& atmosphere,
                                                         const LitRay<T>& ray, const Column<T>& offset,
                                                         T outwards, T altitude, T along,
                                                         const Density<T>& density) {
    const T radius = atmosphere.ground_radius + altitude;
    const T inverse_radius = T(1) / radius;
    const LinePoint<T> on_ray =
        line_point(altitude, radius, inverse_radius, along, ray.air.perigee_radius, ray.air.perigee_altitude);
    const Column<T> beyond = column_outwards<T, Scene>(ray.layers, on_ray, ray.shells, density);
    const T sun_height = ray.sun.perigee_height + outwards * along * ray.sun.cos_theta;
    const LinePoint<T> to_sun = line_towards_sun(altitude, radius, inverse_radius, sun_height);
    const Column<T> sunlit =
        column_to_sun<T, Scene>(ray.layers, atmosphere.ground_radius, to_sun, sun_height < T(0), density);
    const Column<T> passed = column_sum(column_sum(offset, -outwards, beyond), T(1), sunlit);
    const vec3<T> depth = column_optical_depth<T, Scene>(atmosphere, passed);
    return glm::exp(-glm::max(depth, vec3<T>(T(0), T(0), T(0))));
}

/// Sunlight scattered towards the eye by a length of air at one node, dimmed on its way to the node and from
/// there to the eye.
///
/// Units:    altitude and along [L] of the node, along never negative; result [1/(L sr)] per unit of solar
///           irradiance above the air.
/// Domain:   that of node_transmittance.
/// Accuracy: that of node_transmittance.
/// Errors:   none; ignores the ground.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene>
inline vec3<T> node_radiance(const Atmosphere<T>& atmosphere, const LitRay<T>& ray, const Column<T>& offset,
                             T outwards, T altitude, T along, const Density<T>& density) {
    vec3<T> source = ray.rayleigh_source * density.rayleigh;
    if constexpr (Scene::mie) {
        source += ray.mie_source * density.mie;
    }
    return source * node_transmittance<T, Scene>(atmosphere, ray, offset, outwards, altitude, along, density);
}

/// The most that a ray can scatter towards the eye: all that it takes out of light, spread as the strongest
/// phase function spreads it. Keeps absurdly thick or thin layers, which few nodes cannot follow, from
/// making light.
///
///     1.01 max(p_R, p_M) (1 - T),   1 - T at most tau / (1 + tau / 2) where it would cancel
///
/// The hundredth is for the errors of depth and radiance: clear air may come that close to the bound.
///
/// Units:    cos_theta, depth and transmittance [1]; result [1/sr].
/// Shape:    depth, transmittance and the result are spectra.
/// Domain:   depth >= 0; transmittance = exp(-depth).
/// Accuracy: 1 to 3 % above the bound.
/// Errors:   none.
/// Source:   conservation of energy; the fraction is the Pade approximant of 1 - exp(-x).
template <typename T, typename Scene = DefaultScene>
inline vec3<T> most_scattered(const Atmosphere<T>& atmosphere, T cos_theta, const vec3<T>& depth,
                              const vec3<T>& transmittance) {
    T strongest = rayleigh_phase(cos_theta);
    if constexpr (Scene::mie) {
        const vec3<T> aerosol = atmosphere.mie_scattering;
        if (aerosol.x + aerosol.y + aerosol.z > T(0)) {
            strongest = glm::max(strongest, mie_phase<T, Scene>(cos_theta, atmosphere.mie_g));
        }
    }
    const vec3<T> thin = depth / (T(1) + T(0.5) * depth);
    return T(1.01L) * strongest *
           vec3<T>(depth.x < T(0.5) ? thin.x : T(1) - transmittance.x,
                   depth.y < T(0.5) ? thin.y : T(1) - transmittance.y,
                   depth.z < T(0.5) ? thin.z : T(1) - transmittance.z);
}

/// Sunlight scattered once into a view ray, without marching: Scene::nodes samples in each piece of the ray
/// that is lit and on one side of its closest approach to the centre.
///
/// All air between the eye, a sample and the sun comes in closed form, and the samples lie where the
/// light comes from, so that few are enough.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; result per
///           unit of solar irradiance above the air, radiance [1/sr].
/// Domain:   every viewpoint up to 1e12 m from an Earth; distance >= 0, no_surface() for none;
///           visibility in [0, 1].
/// Accuracy: of the luminance by Scene::nodes, docs/trade.md and node_error. With 8 nodes, 95 % of the views
///           and the worst: with ozone 2.5e-4 and 3.2e-3 by day, 2.1e-3 and 5e-3 from sunset on.
/// Errors:   none; no air on the ray gives radiance 0 and transmittance 1.
/// Source:   docs/theory/nodes.md.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
Scattered<T> single_scattering(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                               const vec3<T>& direction, const vec3<T>& to_sun, T distance,
                               const Visibility& visibility = Visibility{}) {
    const AirRay<T> air = air_ray(atmosphere, eye, direction, distance);
    if (!air.in_air) {
        return Scattered<T>{vec3<T>(T(0), T(0), T(0)), vec3<T>(T(1), T(1), T(1))};
    }
    const LitRay<T> ray = lit_ray<T, Scene>(atmosphere, air, eye, direction, to_sun);
    const T along = air.along;

    // The planet's shadow cuts the ray, and so does the shadow of the ozone's upper edge: there the
    // sunlight's air has a kink.
    LineSpan<T> dusk = LineSpan<T>{T(0), T(0)};
    LineSpan<T> dark = LineSpan<T>{T(0), T(0)};
    if constexpr (Scene::planet_shadow) {
        const T radius = atmosphere.ground_radius;
        dark = shadow_span(radius, air.perigee_altitude, ray.sun, T(0));
        dusk = dark;
        if constexpr (Scene::ozone != ozone_none) {
            const vec3<T> absorption = atmosphere.ozone_absorption;
            if (absorption.x + absorption.y + absorption.z > T(0)) {
                dusk = shadow_span(radius, air.perigee_altitude, ray.sun, ray.layers.ozone.edge);
            }
        }
    }
    const bool dims = dusk.begin < dusk.end;
    const bool darkens = dark.begin < dark.end;
    const T extent = air.extent;

    // Down to the closest approach, then up from it. Falling, there is more air outwards from a node than
    // outwards from the eye; climbing, less. The difference is the air between them.
    const bool falls = along < T(0);
    const bool climbs = along + extent > T(0);
    RayPoint<T> here = ray_point<T, Scene>(atmosphere, ray, T(0));
    Column<T> offset = column_sum(Column<T>{T(0), T(0), T(0)}, T(-1), here.outwards);
    T outwards = T(-1);
    bool at_end = false;
    Column<T> swept = Column<T>{T(0), T(0), T(0)};  // the nodes' sum, without ozone
    T swept_extent = T(0);
    vec3<T> radiance = vec3<T>(T(0), T(0), T(0));
    for (int leg = 0; leg < 2; ++leg) {
        const T leg_begin = leg == 1 && falls ? -along : T(0);
        const T leg_end = leg == 0 && climbs ? -along : extent;
        if (leg == 1 && climbs) {
            if (falls) {
                here = ray_point<T, Scene>(atmosphere, ray, leg_begin);
            }
            offset = column_sum(offset, T(2), here.outwards);
            outwards = T(1);
        }
        for (int i = 0; i < 4; ++i) {
            // What is lit, in order: before the dusk, in it, in it again behind the dark, after it.
            const bool there = i == 3 || (dims && (i != 2 || darkens));
            const T piece_begin = i == 0 ? along : (i == 1 ? dusk.begin : (i == 2 ? dark.end : dusk.end));
            const T piece_end = i == 0 ? dusk.begin : (i == 1 && darkens ? dark.begin : dusk.end);
            const T begin = glm::max(i == 3 && !dims ? T(0) : piece_begin - along, leg_begin);
            const T end = i == 3 ? leg_end : glm::min(piece_end - along, leg_end);
            if (there && (leg == 0 ? falls : climbs) && end > begin) {
                if (i > 1 && darkens) {
                    here = ray_point<T, Scene>(atmosphere, ray, begin);
                }
                RayPoint<T> low = here;
                here = ray_point<T, Scene>(atmosphere, ray, end);
                RayPoint<T> high = here;
                if (leg == 0) {
                    high = low;
                    low = here;
                }
                at_end = i == 3 && (leg == 1 || !climbs);

                const T low_along = glm::abs(along + (leg == 0 ? end : begin));
                const NodeMap<T> map =
                    piece_map<T, Scene>(atmosphere, ray, low, high, low_along, end - begin, outwards);
                for (int j = 0; j < Scene::nodes; ++j) {
                    const Node<T> node = node_at(map, gauss_position<T, Scene>(j));
                    const T t = leg == 0 ? end - node.way : begin + node.way;
                    const T altitude = low.altitude + node.rise;
                    const Density<T> density = layer_density<T, Scene>(ray.layers, altitude);
                    const T share = gauss_weight<T, Scene>(j) * node.stretch;
                    swept = column_sum(swept, share, Column<T>{density.rayleigh, density.mie, T(0)});
                    swept_extent += share;
                    const T lit = share * visibility(direction * (air.begin + t));
                    radiance += lit * node_radiance<T, Scene>(atmosphere, ray, offset, outwards, altitude,
                                                              node.along, density);
                }
            }
        }
    }
    if (!at_end) {
        here = ray_point<T, Scene>(atmosphere, ray, extent);
    }
    Column<T> passed = column_sum(offset, -outwards, here.outwards);
    // The difference of two columns outwards has no digits left for a ray much shorter than the layer is
    // tall; its nodes' sum has, where none of it lies in the dark.
    const bool summed = swept_extent > T(0.99L) * extent;
    if (summed && extent < T(0.01L) * ray.layers.rayleigh_height) {
        passed.rayleigh = swept.rayleigh;
    }
    if constexpr (Scene::mie) {
        if (summed && extent < T(0.01L) * ray.layers.mie_height) {
            passed.mie = swept.mie;
        }
    }
    const vec3<T> depth =
        glm::max(column_optical_depth<T, Scene>(atmosphere, passed), vec3<T>(T(0), T(0), T(0)));
    const vec3<T> transmittance = glm::exp(-depth);
    const vec3<T> most = most_scattered<T, Scene>(atmosphere, ray.sun.cos_theta, depth, transmittance);
    return Scattered<T>{glm::min(radiance, most), transmittance};
}

/// Sunlight scattered once into a view ray, by `steps` equal steps through the air.
///
///     L = sum over the samples of T(eye, x) T(x, sun) V(x) (sigma_R rho_R p_R + sigma_M rho_M p_M) step
///
/// The air between the eye and a sample is summed on the way; what passes between a sample and the sun comes
/// in closed form, or from a table by a hook.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; result per
///           unit of solar irradiance above the air, radiance [1/sr].
/// Domain:   every viewpoint up to 1e12 m from an Earth; distance >= 0, no_surface() for none;
///           steps >= 1; visibility in [0, 1].
/// Accuracy: second order in the step, where a step is shorter than the scale heights it crosses.
/// Errors:   none; no air on the ray gives radiance 0 and transmittance 1.
/// Source:   the single-scattering integral, by the midpoint rule.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit,
          typename TransmittanceToSpace = ComputedTransmittance<Scene>>
Scattered<T> single_scattering_marched(
    const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye, const vec3<T>& direction, const vec3<T>& to_sun,
    T distance, int steps, const Visibility& visibility = Visibility{},
    const TransmittanceToSpace& transmittance_to_sun = TransmittanceToSpace{}) {
    const T radius = atmosphere.ground_radius;
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, distance);
    if (!ray.in_air) {
        return Scattered<T>{vec3<T>(T(0), T(0), T(0)), vec3<T>(T(1), T(1), T(1))};
    }
    const T step_length = ray.extent / glm::max(T(steps), T(1));

    const SunOverLine<T> sun = sun_over_line(radius, eye, direction, to_sun);

    Column<T> passed = Column<T>{T(0), T(0), T(0)};
    vec3<T> rayleigh_light = vec3<T>(T(0), T(0), T(0));
    vec3<T> mie_light = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < steps; ++i) {
        const T t = (T(i) + T(0.5)) * step_length;
        const T altitude = glm::max(altitude_along_ray(radius, ray.altitude, ray.along, t), T(0));
        const T sun_height = sun.perigee_height + (ray.along + t) * sun.cos_theta;
        const T mu_s = glm::clamp(sun_height / (radius + altitude), T(-1), T(1));

        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        const Column<T> half_step =
            Column<T>{T(0.5) * step_length * density.rayleigh, T(0.5) * step_length * density.mie,
                      T(0.5) * step_length * density.ozone};
        passed.rayleigh += half_step.rayleigh;
        passed.mie += half_step.mie;
        passed.ozone += half_step.ozone;
        const vec3<T> seen = glm::exp(-column_optical_depth<T, Scene>(atmosphere, passed));
        const vec3<T> sunlit = transmittance_to_sun(atmosphere, altitude, mu_s);
        const T lit_length = step_length * visibility(direction * (ray.begin + t));
        rayleigh_light += seen * sunlit * (lit_length * density.rayleigh);
        if constexpr (Scene::mie) {
            mie_light += seen * sunlit * (lit_length * density.mie);
        }
        passed.rayleigh += half_step.rayleigh;
        passed.mie += half_step.mie;
        passed.ozone += half_step.ozone;
    }

    vec3<T> radiance = atmosphere.rayleigh_scattering * rayleigh_light * rayleigh_phase(sun.cos_theta);
    if constexpr (Scene::mie) {
        radiance +=
            atmosphere.mie_scattering * mie_light * mie_phase<T, Scene>(sun.cos_theta, atmosphere.mie_g);
    }
    return Scattered<T>{radiance, glm::exp(-column_optical_depth<T, Scene>(atmosphere, passed))};
}

}  // namespace airlight
