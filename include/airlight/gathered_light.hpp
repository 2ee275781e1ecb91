#pragma once

#include <airlight/constants.hpp>
#include <airlight/gathering.hpp>
#include <airlight/multiple_scattering.hpp>
#include <airlight/sky_irradiance.hpp>

namespace airlight {

/// Light that was scattered or reflected, as one point of the air receives it.
template <typename T>
struct GatheredLight {
    DiffuseLight<T> light;        ///< [1/sr] as the air scatters it
    SkyIrradiance<T> irradiance;  ///< [1] as surfaces receive it
};

/// Light that arrives at a point from one direction: of the first order, scattered once or straight off the
/// sunlit ground, or of the next, from the hooks' order before.
///
/// Units:    altitude [L]; result [1/sr] per unit of solar irradiance above the air.
/// Domain:   altitude from 0 to the top; direction and to_sun unit vectors in a frame whose third axis is the
///           vertical.
/// Accuracy: that of single_scattering and diffuse_scattering.
/// Errors:   none.
/// Source:   the two of them; the ground reflects as Lambert's law says.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename GroundIrradiance = NoIrradiance, typename Visibility = AlwaysLit>
vec3<T> incoming_light(const Atmosphere<T>& atmosphere, T altitude, const vec3<T>& direction,
                       const vec3<T>& to_sun, bool first_order,
                       const MultipleScattering& multiple_scattering = MultipleScattering{},
                       const GroundIrradiance& ground_irradiance = GroundIrradiance{},
                       const Visibility& visibility = Visibility{}) {
    const Viewpoint<T> point = Viewpoint<T>{altitude, vec3<T>(T(0), T(0), T(1))};
    vec3<T> radiance = vec3<T>(T(0), T(0), T(0));
    if (first_order) {
        const Scattered<T> once =
            single_scattering<T, Scene>(atmosphere, point, direction, to_sun, no_surface<T>(), visibility);
        radiance = once.radiance;
    } else {
        radiance = diffuse_scattering<T, Scene>(atmosphere, point, direction, to_sun, no_surface<T>(),
                                                multiple_scattering);
    }
    const AirRay<T> ray = air_ray(atmosphere, point, direction, no_surface<T>());
    if (ray.reaches_ground) {
        const T sun_height =
            (atmosphere.ground_radius + altitude) * to_sun.z + ray.extent * dot_product(direction, to_sun);
        const T mu_s = glm::clamp(sun_height / atmosphere.ground_radius, T(-1), T(1));
        vec3<T> irradiance = vec3<T>(T(0), T(0), T(0));
        if (first_order) {
            irradiance = direct_irradiance<T, Scene>(atmosphere, T(0), mu_s);
        } else {
            irradiance = ground_irradiance(mu_s);
        }
        radiance += transmittance<T, Scene>(atmosphere, altitude, direction.z, ray.extent) *
                    atmosphere.ground_albedo * irradiance / pi<T>;
    }
    return radiance;
}

/// One texel of one order of the diffuse table: light from 16 azimuths on each side of the sun's, at
/// Scene::nodes heights above and as many below the horizon.
///
/// Order by order: the first from the sun, each next with hooks that return the one before. Their sum is
/// the table.
///
/// Units:    altitude [L]; mu_s [1], cosine between the sun and the vertical.
/// Domain:   altitude from 0 to the top; mu_s in [-1, 1].
/// Accuracy: docs/tables.md.
/// Errors:   a sun within 1.7 degrees of the zenith or nadir counts as that far from it.
/// Source:   the moments' definition, by Gauss's rule in the root of the cosine's distance from the horizon.
template <typename T, typename Scene = DefaultScene, typename MultipleScattering = NoDiffuseLight,
          typename GroundIrradiance = NoIrradiance, typename Visibility = AlwaysLit>
GatheredLight<T> gathered_light(const Atmosphere<T>& atmosphere, T altitude, T mu_s, bool first_order,
                                const MultipleScattering& multiple_scattering = MultipleScattering{},
                                const GroundIrradiance& ground_irradiance = GroundIrradiance{},
                                const Visibility& visibility = Visibility{}) {
    const vec3<T> none = vec3<T>(T(0), T(0), T(0));
    DiffuseLight<T> light = even_light(none);
    SkyIrradiance<T> irradiance = SkyIrradiance<T>{none, none, none};
    const T above = glm::max(altitude, T(0));
    const vec3<T> to_sun = sun_over_x(glm::clamp(mu_s, T(-0.99955L), T(0.99955L)));
    const T sun_sine = to_sun.x;
    const T strength = T(4) * pi<T>;
    T up = T(0);
    T down = T(0);
    T sunward = T(0);
    T away = T(0);
    T aside = T(0);
    for (int side = 0; side < 2; ++side) {
        for (int polar = 0; polar < Scene::nodes; ++polar) {
            for (int azimuth = 0; azimuth < 16; ++azimuth) {
                const SphereDirection<T> from =
                    sphere_direction<T, Scene>(atmosphere.ground_radius, above, side, polar, azimuth);
                const T x = from.sine * from.cos_azimuth;
                const T y = from.sine * from.sin_azimuth;
                const T z = from.mu;
                const T share = T(2) * from.solid_angle / strength;
                const vec3<T> arriving =
                    share * incoming_light<T, Scene>(atmosphere, above, vec3<T>(x, y, z), to_sun, first_order,
                                                     multiple_scattering, ground_irradiance, visibility);
                light.mean += arriving;
                light.vertical += (T(1.5) * z * z - T(0.5)) * arriving;
                light.slanted += (x * z / sun_sine) * arriving;
                light.across += ((x * x - y * y) / (sun_sine * sun_sine)) * arriving;
                irradiance.down += (strength * glm::max(z, T(0))) * arriving;
                irradiance.up += (strength * glm::max(-z, T(0))) * arriving;
                irradiance.sunward += (strength * x / sun_sine) * arriving;
                if constexpr (Scene::mie) {
                    const T g = atmosphere.mie_g;
                    const T to_up = mie_phase<T, Scene>(z, g);
                    const T to_down = mie_phase<T, Scene>(-z, g);
                    const T to_sunward = mie_phase<T, Scene>(x, g);
                    const T to_away = mie_phase<T, Scene>(-x, g);
                    const T to_aside = mie_phase<T, Scene>(y, g) + mie_phase<T, Scene>(-y, g);
                    light.aerosol_up += to_up * arriving;
                    light.aerosol_down += to_down * arriving;
                    light.aerosol_sunward += to_sunward * arriving;
                    light.aerosol_away += to_away * arriving;
                    light.aerosol_aside += to_aside * arriving;
                    up += to_up * share;
                    down += to_down * share;
                    sunward += to_sunward * share;
                    away += to_away * share;
                    aside += to_aside * share;
                }
            }
        }
    }
    if constexpr (Scene::mie) {
        // Few directions do not find all of a narrow lobe: what they find of it counts as the whole.
        light.aerosol_up /= glm::max(up, smallest_share<T>);
        light.aerosol_down /= glm::max(down, smallest_share<T>);
        light.aerosol_sunward /= glm::max(sunward, smallest_share<T>);
        light.aerosol_away /= glm::max(away, smallest_share<T>);
        light.aerosol_aside /= glm::max(aside, smallest_share<T>);
    }
    return GatheredLight<T>{light, irradiance};
}

/// Light of one gathering and a share of another's.
///
///     a + share b, member by member
///
/// Units:    those of a and b; share [1].
/// Domain:   every number.
/// Accuracy: 2 roundoffs of a member's parts.
/// Errors:   none.
/// Source:   none.
template <typename T>
GatheredLight<T> sum_of_light(const GatheredLight<T>& a, const vec3<T>& share, const GatheredLight<T>& b) {
    return GatheredLight<T>{
        DiffuseLight<T>{a.light.mean + share * b.light.mean, a.light.vertical + share * b.light.vertical,
                        a.light.slanted + share * b.light.slanted, a.light.across + share * b.light.across,
                        a.light.aerosol_up + share * b.light.aerosol_up,
                        a.light.aerosol_down + share * b.light.aerosol_down,
                        a.light.aerosol_sunward + share * b.light.aerosol_sunward,
                        a.light.aerosol_away + share * b.light.aerosol_away,
                        a.light.aerosol_aside + share * b.light.aerosol_aside},
        SkyIrradiance<T>{a.irradiance.down + share * b.irradiance.down,
                         a.irradiance.up + share * b.irradiance.up,
                         a.irradiance.sunward + share * b.irradiance.sunward}};
}

/// How much the last order counts, so that it stands for all that follow as if each were as much weaker than
/// the one before as it is itself.
///
///     1 / (1 - last / before)
///
/// Units:    before and last in one unit, of the last order and the one before it; result [1].
/// Domain:   before and last >= 0.
/// Accuracy: 3 roundoffs.
/// Errors:   none; from 1 to 20, also where the last order is no weaker than the one before.
/// Source:   sum of a geometric series.
template <typename T>
T gain_of_last_order(T before, T last) {
    const T ratio = before > T(0) ? glm::min(last / before, T(0.95L)) : T(0);
    return T(1) / (T(1) - ratio);
}

}  // namespace airlight
