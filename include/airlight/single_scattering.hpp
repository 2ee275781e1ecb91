#pragma once

#include <airlight/phase.hpp>
#include <airlight/transmittance.hpp>
#include <airlight/view_path.hpp>

namespace airlight {

/// What the air adds to a view ray, and the share it lets through.
template <typename T>
struct Scattered {
    vec3<T> radiance;       ///< [1/sr] towards the eye, per unit of solar irradiance above the air
    vec3<T> transmittance;  ///< [1] of the whole ray, in [0, 1]
};

/// Phase function of the aerosol that the scene is compiled with.
///
/// Units:    cos_theta [1]; g [1], or the droplet diameter in um for phase_fog; result [1/sr].
/// Domain:   that of the chosen phase function.
/// Accuracy: that of the chosen phase function.
/// Errors:   that of the chosen phase function.
/// Source:   cornette_shanks_phase, henyey_greenstein_phase, fog_phase.
template <typename T, typename Scene = DefaultScene>
T mie_phase(T cos_theta, T g) {
    if constexpr (Scene::mie_phase == phase_henyey_greenstein) {
        return henyey_greenstein_phase(cos_theta, g);
    } else if constexpr (Scene::mie_phase == phase_fog) {
        return fog_phase(cos_theta, g);
    } else {
        return cornette_shanks_phase(cos_theta, g);
    }
}

/// Sunlight scattered once into a view ray, by `steps` equal steps through the air.
///
///     L = sum over the samples of T(eye, x) T(x, sun) V(x) (sigma_R rho_R p_R + sigma_M rho_M p_M) step
///
/// The air between the eye and a sample is summed on the way; the air between a sample and the
/// sun comes in closed form.
///
/// Units:    lengths in the atmosphere's unit [L]; direction and to_sun unit vectors; result per
///           unit of solar irradiance above the air, radiance [1/sr].
/// Domain:   every viewpoint up to 1e12 m from an Earth; distance >= 0, no_surface() for none;
///           steps >= 1; visibility in [0, 1].
/// Accuracy: second order in the step, where a step is shorter than the scale heights it crosses.
/// Errors:   none; no air on the ray gives radiance 0 and transmittance 1.
/// Source:   the single-scattering integral, by the midpoint rule.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
Scattered<T> single_scattering_marched(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                                       const vec3<T>& direction, const vec3<T>& to_sun, T distance, int steps,
                                       const Visibility& visibility = Visibility{}) {
    const T radius = atmosphere.ground_radius;
    const AirRay<T> ray = air_ray(atmosphere, eye, direction, distance);
    if (!ray.in_air) {
        return Scattered<T>{vec3<T>(T(0), T(0), T(0)), vec3<T>(T(1), T(1), T(1))};
    }
    const T step_length = ray.extent / glm::max(T(steps), T(1));

    // The sun's height over the ray: the closest approach to the centre, and the way from there.
    // The closest approach comes from cross products, which keep digits for far eyes.
    const T cos_theta = dot_product(direction, to_sun);
    const vec3<T> across = glm::cross(direction, cross_of_unit_vectors(eye.up, direction));
    const T perigee_to_sun = (radius + glm::max(eye.altitude, T(0))) * dot_product(across, to_sun);

    Column<T> passed = Column<T>{T(0), T(0), T(0)};
    vec3<T> rayleigh_light = vec3<T>(T(0), T(0), T(0));
    vec3<T> mie_light = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < steps; ++i) {
        const T t = (T(i) + T(0.5)) * step_length;
        const T altitude = glm::max(altitude_along_ray(radius, ray.altitude, ray.along, t), T(0));
        const T sun_height = perigee_to_sun + (ray.along + t) * cos_theta;
        const T mu_s = glm::clamp(sun_height / (radius + altitude), T(-1), T(1));

        const Density<T> density = relative_density<T, Scene>(atmosphere, altitude);
        const Column<T> half_step =
            Column<T>{T(0.5) * step_length * density.rayleigh, T(0.5) * step_length * density.mie,
                      T(0.5) * step_length * density.ozone};
        passed.rayleigh += half_step.rayleigh;
        passed.mie += half_step.mie;
        passed.ozone += half_step.ozone;
        const vec3<T> seen = glm::exp(-column_optical_depth<T, Scene>(atmosphere, passed));
        const vec3<T> sunlit = transmittance_to_space<T, Scene>(atmosphere, altitude, mu_s);
        const T lit_length = step_length * visibility(direction * (ray.begin + t));
        rayleigh_light += seen * sunlit * (lit_length * density.rayleigh);
        if constexpr (Scene::mie) {
            mie_light += seen * sunlit * (lit_length * density.mie);
        }
        passed.rayleigh += half_step.rayleigh;
        passed.mie += half_step.mie;
        passed.ozone += half_step.ozone;
    }

    vec3<T> radiance = atmosphere.rayleigh_scattering * rayleigh_light * rayleigh_phase(cos_theta);
    if constexpr (Scene::mie) {
        radiance += atmosphere.mie_scattering * mie_light * mie_phase<T, Scene>(cos_theta, atmosphere.mie_g);
    }
    return Scattered<T>{radiance, glm::exp(-column_optical_depth<T, Scene>(atmosphere, passed))};
}

}  // namespace airlight
