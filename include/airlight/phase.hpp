#pragma once

#include <airlight/constants.hpp>
#include <airlight/scene.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// Phase function of a medium that scatters evenly in all directions.
///
///     p = 1 / (4 pi)
///
/// Units:    result [1/sr], integrates to 1 over the sphere.
/// Domain:   none, it takes no argument.
/// Accuracy: correctly rounded to 1 ulp.
/// Errors:   none.
/// Source:   definition.
template <typename T>
constexpr T isotropic_phase() {
    return T(1) / (T(4) * pi<T>);
}

/// Rayleigh phase function: the share of light that air molecules scatter per
/// unit solid angle, for unpolarised light.
///
///     p(cos_theta) = 3 / (16 pi) * (1 + cos_theta^2)
///
/// Units:    cos_theta [1]; result [1/sr], integrates to 1 over the sphere.
/// Domain:   cos_theta in [-1, 1]; 1 is forward (light keeps its direction).
/// Accuracy: under 2 ulp (measured: 1.61 float, 1.50 double, 3e5 samples).
/// Errors:   none; outside the domain it evaluates the same polynomial.
/// Source:   Bruneton, Precomputed Atmospheric Scattering (2017), functions.glsl. Leaves out
///           air's depolarisation, which moves it by 1.4 %.
template <typename T>
constexpr T rayleigh_phase(T cos_theta) {
    const T norm = T(3) / (T(16) * pi<T>);
    return norm * (T(1) + cos_theta * cos_theta);
}

/// The squared distance 1 + g^2 - 2 g cos_theta that all Henyey-Greenstein forms divide by.
///
///     (1 - |g|)^2 + 2 |g| (1 - sign(g) cos_theta)
///
/// Written as a sum of two squares' worth of light: nothing cancels near the peak.
///
/// Units:    cos_theta, g and result [1].
/// Domain:   cos_theta in [-1, 1], rounding past the ends is forgiven; g in [-1, 1].
/// Accuracy: under 3 ulp plus the roundoff of cos_theta near 1.
/// Errors:   none; 0 only for |g| = 1 in the peak.
/// Source:   algebra.
template <typename T>
constexpr T henyey_greenstein_denominator(T cos_theta, T g) {
    const T strength = glm::abs(g);
    const T off_peak = glm::max(g < T(0) ? T(1) + cos_theta : T(1) - cos_theta, T(0));
    return (T(1) - strength) * (T(1) - strength) + T(2) * strength * off_peak;
}

/// Henyey-Greenstein phase function, a one-parameter lobe.
///
///     p = (1 - g^2) / (4 pi (1 + g^2 - 2 g cos_theta)^(3/2))
///
/// Units:    cos_theta and g [1]; result [1/sr], integrates to 1 over the sphere.
/// Domain:   cos_theta in [-1, 1], 1 is forward; g in (-1, 1) is the mean cosine.
/// Accuracy: 8 roundoffs times the condition |p| + sum |dp/dx| |x| (measured: 5.8 float, 5.1 double,
///           3e5 samples).
/// Errors:   g = 1 or -1 gives 0 off the peak and divides zero by zero in it.
/// Source:   Jendersie and d'Eon, An Approximate Mie Scattering Function for Fog and Cloud
///           Rendering (2023), as implemented in webgpu-sky-atmosphere.
template <typename T>
T henyey_greenstein_phase(T cos_theta, T g) {
    const T d = henyey_greenstein_denominator(cos_theta, g);
    return (T(1) - g) * (T(1) + g) / (T(4) * pi<T> * d * glm::sqrt(d));
}

/// Cornette-Shanks phase function: Henyey-Greenstein's lobe that becomes Rayleigh's for g = 0.
///
///     p = 3 / (8 pi) * (1 - g^2) (1 + cos_theta^2) / ((2 + g^2) (1 + g^2 - 2 g cos_theta)^(3/2))
///
/// g is a shape parameter, not the mean cosine: 0.76 gives a mean cosine of 0.810, 0.8 gives 0.844.
///
/// Units:    cos_theta and g [1]; result [1/sr], integrates to 1 over the sphere.
/// Domain:   cos_theta in [-1, 1], 1 is forward; g in (-1, 1).
/// Accuracy: 8 roundoffs times the condition |p| + sum |dp/dx| |x| (measured: 6.0 float, 5.2 double,
///           3e5 samples).
/// Errors:   g = 1 or -1 gives 0 off the peak and divides zero by zero in it.
/// Source:   Bruneton, Precomputed Atmospheric Scattering (2017), functions.glsl.
template <typename T>
T cornette_shanks_phase(T cos_theta, T g) {
    const T d = henyey_greenstein_denominator(cos_theta, g);
    const T norm = T(3) * ((T(1) - g) * (T(1) + g)) / (T(8) * pi<T> * (T(2) + g * g));
    return norm * (T(1) + cos_theta * cos_theta) / (d * glm::sqrt(d));
}

/// Schlick's phase function, a lobe without a square root.
///
///     p = (1 - k^2) / (4 pi (1 - k cos_theta)^2)
///
/// k = 1.55 g - 0.55 g^3 resembles Henyey-Greenstein with g.
///
/// Units:    cos_theta and k [1]; result [1/sr], integrates to 1 over the sphere.
/// Domain:   cos_theta in [-1, 1], 1 is forward; k in (-1, 1).
/// Accuracy: 6 roundoffs times the condition |p| + sum |dp/dx| |x| (measured: 4.8, 3e5 samples).
/// Errors:   k = 1 or -1 gives 0 off the peak and divides zero by zero in it.
/// Source:   Blasi, Le Saec and Schlick, A rendering algorithm for discrete volume density
///           objects (1993), with the sign of forward light as in the rest of this header.
template <typename T>
T schlick_phase(T cos_theta, T k) {
    const T strength = glm::abs(k);
    const T off_peak = glm::max(k < T(0) ? T(1) + cos_theta : T(1) - cos_theta, T(0));
    const T d = (T(1) - strength) + strength * off_peak;
    return (T(1) - k) * (T(1) + k) / (T(4) * pi<T> * d * d);
}

/// Draine's phase function: Henyey-Greenstein for alpha = 0, Cornette-Shanks for alpha = 1.
///
///     p = (1 - g^2) (1 + alpha cos_theta^2)
///         / (4 pi (1 + g^2 - 2 g cos_theta)^(3/2) (1 + alpha (1 + 2 g^2) / 3))
///
/// Units:    cos_theta, g and alpha [1]; result [1/sr], integrates to 1 over the sphere.
/// Domain:   cos_theta in [-1, 1], 1 is forward; g in (-1, 1); alpha >= 0.
/// Accuracy: 10 roundoffs times the condition |p| + sum |dp/dx| |x| (measured: 8.4 float, 7.0 double,
///           3e5 samples).
/// Errors:   g = 1 or -1 gives 0 off the peak and divides zero by zero in it.
/// Source:   Jendersie and d'Eon, An Approximate Mie Scattering Function for Fog and Cloud
///           Rendering (2023), as implemented in webgpu-sky-atmosphere.
template <typename T>
T draine_phase(T cos_theta, T g, T alpha) {
    const T lobe = henyey_greenstein_phase(cos_theta, g);
    const T norm = T(1) + alpha * ((T(1) + T(2) * g * g) / T(3));
    return lobe * ((T(1) + alpha * (cos_theta * cos_theta)) / norm);
}

/// Phase function of fog and cloud droplets, a fit to Mie theory for white light.
///
///     p = (1 - w) henyey_greenstein(g_hg) + w draine(g_d, alpha), all four fitted over the diameter
///
/// Units:    cos_theta [1]; droplet_diameter_um [um]; result [1/sr], integrates to 1 over the sphere.
/// Domain:   cos_theta in [-1, 1], 1 is forward; droplet diameters from 5 to 50 um, others are
///           clamped to these ends.
/// Accuracy: the fit's own error against Mie theory is the authors'; rounding 40 roundoffs times the
///           condition |p| + sum |dp/dx| |x| (measured: 11.5), because g_hg comes within 0.002 of 1.
/// Errors:   none.
/// Source:   Jendersie and d'Eon, An Approximate Mie Scattering Function for Fog and Cloud
///           Rendering (2023), equations 4 to 7, as implemented in webgpu-sky-atmosphere.
template <typename T>
T fog_phase(T cos_theta, T droplet_diameter_um) {
    const T d = glm::clamp(droplet_diameter_um, T(5), T(50));
    const T g_hg = glm::exp(T(-0.0990567L) / (d - T(1.67154L)));
    const T g_d = glm::exp(T(-2.20679L) / (d + T(3.91029L)) - T(0.428934L));
    const T alpha = glm::exp(T(3.62489L) - T(8.29288L) / (d + T(5.52825L)));
    const T share = glm::exp(T(-0.599085L) / (d - T(0.641583L)) - T(0.665888L));
    const T lobe = (T(1) - share) * henyey_greenstein_phase(cos_theta, g_hg);
    return lobe + share * draine_phase(cos_theta, g_d, alpha);
}

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

/// Cosine of a scattering angle with the distribution of rayleigh_phase, from an even number.
///
///     cos_theta = 2 sinh(asinh(4 u - 2) / 3), the real root of x^3 + 3 x = 8 u - 4
///
/// Units:    u and result [1].
/// Domain:   u in [0, 1]; 0 gives -1, backward, and 1 gives 1.
/// Accuracy: 4 roundoffs of u (measured: 1.2).
/// Errors:   none.
/// Source:   Cardano's formula.
template <typename T>
T sample_rayleigh_phase(T u) {
    const T q = T(4) * u - T(2);
    const T size = glm::abs(q);
    const T root = glm::pow(size + glm::sqrt(q * q + T(1)), T(0.333333333333333333333333333333333333L));
    const T x = glm::min(root - T(1) / root, T(1));
    return q < T(0) ? -x : x;
}

/// Cosine of a scattering angle with the distribution of henyey_greenstein_phase, from an even number.
///
///     cos_theta = (1 + g^2 - ((1 - g^2) / (1 + g s))^2) / (2 g),   s = 2 u - 1
///
/// multiplied out, so that nothing is divided by g.
///
/// Units:    u, g and result [1].
/// Domain:   u in [0, 1]; g in (-1, 1), 0 gives all cosines alike.
/// Accuracy: 16 roundoffs of u times 1 + 2 pi henyey_greenstein_phase (measured: 13.9).
/// Errors:   g = 1 or -1 divides by zero at one end of u.
/// Source:   Henyey and Greenstein's distribution inverted.
template <typename T>
T sample_henyey_greenstein_phase(T u, T g) {
    const T s = T(2) * u - T(1);
    const T square = g * g;
    const T over = T(2) * s * (T(1) + square) + g * (s * s + T(3)) - g * square * ((T(1) - s) * (T(1) + s));
    const T under = T(1) + g * s;
    return glm::clamp(over / (T(2) * under * under), T(-1), T(1));
}

}  // namespace airlight
