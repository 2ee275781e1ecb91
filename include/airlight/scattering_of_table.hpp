#pragma once

#include <airlight/single_scattering.hpp>

namespace airlight {

/// Hook: what a table holds for a ray of light scattered once [1]: that part of single_inscatter, rayleigh or
/// mie, of which the hook has its name. No phase function.
struct NothingScattered {
    template <typename T>
    vec3<T> operator()([[maybe_unused]] T altitude, [[maybe_unused]] T mu, [[maybe_unused]] T mu_s,
                       [[maybe_unused]] T nu, [[maybe_unused]] bool reaches_ground) const {
        return vec3<T>(T(0), T(0), T(0));
    }
};

/// Hook: what a table holds for a ray of light scattered twice and more: radiance [1/sr], the sum of all its
/// orders' next_order_radiance.
struct NoMultipleRadiance {
    template <typename T>
    vec3<T> operator()([[maybe_unused]] T altitude, [[maybe_unused]] T mu, [[maybe_unused]] T mu_s,
                       [[maybe_unused]] T nu, [[maybe_unused]] bool reaches_ground) const {
        return vec3<T>(T(0), T(0), T(0));
    }
};

/// Radiance that the air adds to a ray, from what a table holds for it: the phase functions come in here.
///
///     L = p_R(nu) R + p_M(nu) M + L_multiple
///
/// The higher orders come as radiance: they are too even to gain from a phase function, and divided by one
/// they are interpolated worse.
///
/// Units:    altitude [L]; mu, mu_s and nu [1]; result [1/sr]. scattered_rayleigh and scattered_mie are the
///           parts of single_inscatter [1], multiple_radiance is a sum of next_order_radiance [1/sr].
/// Domain:   that of single_inscatter.
/// Accuracy: that of the table.
/// Errors:   none.
/// Source:   Elek (2009); Bruneton and Neyret (2008).
template <typename T, typename Scene = DefaultScene, typename ScatteredRayleigh = NothingScattered,
          typename ScatteredMie = NothingScattered, typename MultipleRadiance = NoMultipleRadiance>
vec3<T> radiance_of_table(const Atmosphere<T>& atmosphere, T altitude, T mu, T mu_s, T nu,
                          bool reaches_ground,
                          const ScatteredRayleigh& scattered_rayleigh = ScatteredRayleigh{},
                          const ScatteredMie& scattered_mie = ScatteredMie{},
                          const MultipleRadiance& multiple_radiance = MultipleRadiance{}) {
    vec3<T> radiance = multiple_radiance(altitude, mu, mu_s, nu, reaches_ground) +
                       rayleigh_phase(nu) * scattered_rayleigh(altitude, mu, mu_s, nu, reaches_ground);
    if constexpr (Scene::mie) {
        radiance +=
            mie_phase<T, Scene>(nu, atmosphere.mie_g) * scattered_mie(altitude, mu, mu_s, nu, reaches_ground);
    }
    return radiance;
}

/// What the air adds to a view ray, and the share it lets through, by a table of scattered light: the twin of
/// single_scattering with every order that the table holds.
///
///     L = S(eye) - T(eye, surface) S(surface)
///
/// The ray to a surface is the difference of two look-ups. Close to a surface both are nearly alike and
/// their errors are not, so that the difference is kept between 0 and S(eye): never negative, never more than
/// the endless ray, but the haze before a hill a kilometre away is only as good as the table. Order 1 is
/// better left to single_scattering there: without the first two hooks this is what to add to it.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; result per unit of
///           solar irradiance above the air, radiance [1/sr]; the hooks as in radiance_of_table.
/// Domain:   that of single_scattering.
/// Accuracy: that of the table; transmittance that of transmittance.
/// Errors:   none; no air on the ray gives radiance 0 and transmittance 1.
/// Source:   Bruneton and Neyret, Precomputed atmospheric scattering (2008), aerial perspective.
template <typename T, typename Scene = DefaultScene, typename ScatteredRayleigh = NothingScattered,
          typename ScatteredMie = NothingScattered, typename MultipleRadiance = NoMultipleRadiance>
Scattered<T> scattering_of_table(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                                 const vec3<T>& direction, const vec3<T>& to_sun, T distance,
                                 const ScatteredRayleigh& scattered_rayleigh = ScatteredRayleigh{},
                                 const ScatteredMie& scattered_mie = ScatteredMie{},
                                 const MultipleRadiance& multiple_radiance = MultipleRadiance{}) {
    const vec3<T> nothing = vec3<T>(T(0), T(0), T(0));
    const AirRay<T> air = air_ray(atmosphere, eye, direction, distance);
    if (!air.in_air) {
        return Scattered<T>{nothing, vec3<T>(T(1), T(1), T(1))};
    }
    const SunOverLine<T> sun = sun_over_line(atmosphere.ground_radius, eye, direction, to_sun);
    const T nu = glm::clamp(sun.cos_theta, T(-1), T(1));
    const bool to_ground = air.perigee_altitude < T(0) && air.along < T(0);

    const T radius = atmosphere.ground_radius + air.altitude;
    const T mu = glm::clamp(air.along / radius, T(-1), T(1));
    const T mu_s = glm::clamp((sun.perigee_height + air.along * nu) / radius, T(-1), T(1));
    const vec3<T> transmitted = transmittance<T, Scene>(atmosphere, air.altitude, mu, air.extent);
    const vec3<T> whole = radiance_of_table<T, Scene>(atmosphere, air.altitude, mu, mu_s, nu, to_ground,
                                                      scattered_rayleigh, scattered_mie, multiple_radiance);
    // As air_ray measures it: the sum of begin and extent may round to less than distance.
    const bool ends_in_air = !air.reaches_ground && air.extent >= distance - air.begin;
    if (!ends_in_air) {
        return Scattered<T>{whole, transmitted};
    }
    const T end_along = air.along + air.extent;
    const T end_altitude =
        glm::max(altitude_along_ray(atmosphere.ground_radius, air.altitude, air.along, air.extent), T(0));
    const T end_radius = atmosphere.ground_radius + end_altitude;
    const T end_mu = glm::clamp(end_along / end_radius, T(-1), T(1));
    const T end_mu_s = glm::clamp((sun.perigee_height + end_along * nu) / end_radius, T(-1), T(1));
    const vec3<T> behind =
        radiance_of_table<T, Scene>(atmosphere, end_altitude, end_mu, end_mu_s, nu, to_ground,
                                    scattered_rayleigh, scattered_mie, multiple_radiance);
    return Scattered<T>{glm::clamp(whole - transmitted * behind, nothing, whole), transmitted};
}

}  // namespace airlight
