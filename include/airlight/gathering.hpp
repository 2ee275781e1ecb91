#pragma once

#include <airlight/constants.hpp>
#include <airlight/gauss.hpp>
#include <airlight/table_mapping.hpp>
#include <airlight/transmittance.hpp>

namespace airlight {

/// Cosines of the azimuths of sphere_direction, those before 90 degrees [1].
template <typename T>
inline constexpr T azimuth_cosines[8] = {T(0.99518472667219688624L), T(0.95694033573220886494L),
                                         T(0.88192126434835502971L), T(0.77301045336273696081L),
                                         T(0.63439328416364549822L), T(0.47139673682599764856L),
                                         T(0.29028467725446236764L), T(0.098017140329560601994L)};

/// A direction of the rule by which light is gathered from the whole sphere. The sun stands at azimuth 0; the
/// direction counts twice, left and right of it.
template <typename T>
struct SphereDirection {
    T mu;           ///< [1] cosine to the vertical
    T sine;         ///< [1] of the same angle
    T cos_azimuth;  ///< [1] of the angle from the sun's azimuth
    T sin_azimuth;  ///< [1] of the same angle, positive
    T solid_angle;  ///< [sr] that one of the two stands for
};

/// Hook: irradiance [1] of level ground under a sun at cosine `mu_s`, by the light that the next order is
/// made from.
struct NoIrradiance {
    template <typename T>
    vec3<T> operator()([[maybe_unused]] T mu_s) const {
        return vec3<T>(T(0), T(0), T(0));
    }
};

/// A direction of the rule by which light is gathered: Scene::nodes polar angles above the horizon and as
/// many below it, close to the horizon where the light changes most, and 32 azimuths.
///
///     mu = horizon +- (1 -+ horizon) u^2,   u of Gauss and Legendre
///
/// Units:    lengths in one unit [L].
/// Domain:   altitude >= 0; side 0 for the sky, 1 for the ground; polar from 0 to Scene::nodes - 1, from the
///           horizon on; azimuth from 0 to 15.
/// Accuracy: 4 ulp; all solid angles together 4 pi.
/// Errors:   none in the domain.
/// Source:   Gauss-Legendre quadrature after a change of variable; equal steps on a circle.
template <typename T, typename Scene = DefaultScene>
SphereDirection<T> sphere_direction(T ground_radius, T altitude, int side, int polar, int azimuth) {
    const T horizon = glm::max(horizon_cosine(ground_radius, altitude), T(-1));
    const T u = gauss_position<T, Scene>(polar);
    const T reach = side == 0 ? T(1) - horizon : T(1) + horizon;
    const T mu = side == 0 ? horizon + reach * (u * u) : horizon - reach * (u * u);
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    const T cosine = azimuth < 8 ? azimuth_cosines<T>[azimuth] : -azimuth_cosines<T>[15 - azimuth];
    const T across = azimuth < 8 ? azimuth_cosines<T>[7 - azimuth] : azimuth_cosines<T>[azimuth - 8];
    const T solid_angle = gauss_weight<T, Scene>(polar) * u * reach * (pi<T> * T(0.125));
    return SphereDirection<T>{mu, sine, cosine, across, solid_angle};
}

/// Irradiance of level ground, or of a level surface over it, straight from the sun.
///
/// Units:    altitude [L]; mu_s [1]; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   that of transmittance_to_space.
/// Accuracy: that of transmittance_to_space.
/// Errors:   none; a sun below the horizontal gives 0.
/// Source:   Lambert's cosine law.
template <typename T, typename Scene = DefaultScene>
vec3<T> direct_irradiance(const Atmosphere<T>& atmosphere, T altitude, T mu_s) {
    return glm::max(mu_s, T(0)) * transmittance_to_space<T, Scene>(atmosphere, altitude, mu_s);
}

}  // namespace airlight
