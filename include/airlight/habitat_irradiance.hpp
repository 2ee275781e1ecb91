#pragma once

#include <airlight/habitat_mapping.hpp>
#include <airlight/strip_scattering.hpp>

namespace airlight {

/// Irradiance of a surface in a habitat by a strip of light, past the air and past what hides it.
///
/// strip_irradiance times the mean of what passes over points as those of strip_source, of the part that
/// stands above the surface's plane, each weighted with its cosine to the normal.
///
/// Units:    position [L]; normal a unit vector; result as radiance, times sr.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_irradiance and habitat_column; pieces >= 1.
/// Accuracy: 0.1 % for 95 % of places with one piece; what is hidden to a point's weight, 0.33 / pieces.
/// Errors:   none; with pieces below 1, 0.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> strip_irradiance_in_air(const HabitatAir<T>& air, const LinearLight<T>& light,
                                const vec3<T>& position, const vec3<T>& normal, int pieces,
                                const LightVisibility& light_visibility = LightVisibility{}) {
    const StripView<T> view = strip_view(light, position);
    vec3<T> sum = vec3<T>(T(0), T(0), T(0));
    const StripPart<T> part = strip_part_above(view, normal);
    if (view.span <= T(0) || !part.above) {
        return sum;
    }
    StripView<T> seen = view;
    seen.begin = part.begin;
    seen.end = part.end;
    T weights = T(0);
    for (int piece = 0; piece < pieces; ++piece) {
        for (int i = 0; i < 4; ++i) {
            const T share = (T(piece) + gauss_4_positions<T>[i]) / T(pieces);
            const vec3<T> to_light = strip_point(seen, share);
            const vec3<T> light_position = position + to_light;
            const T way = glm::max(glm::sqrt(dot_product(to_light, to_light)), view.distance);
            const T cosine = glm::max(dot_product(to_light, normal) / way, T(0));
            const vec3<T> passed = habitat_transmittance<T, Scene>(air, light_position, position);
            const T weight = gauss_4_weights<T>[i] * cosine;
            sum += (weight * light_visibility(light_position, position)) * passed;
            weights += weight;
        }
    }
    if (weights <= T(0)) {
        return sum;
    }
    return strip_irradiance(light, position, normal) * (sum / weights);
}

/// Irradiance of a surface in a habitat by its six strips, past the air and past what hides them.
///
/// Units:    those of strip_irradiance_in_air.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_irradiance_in_air.
/// Accuracy: that of strip_irradiance_in_air.
/// Errors:   those of strip_irradiance_in_air.
/// Source:   definition.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> habitat_irradiance(const HabitatAir<T>& air, const HabitatLights<T>& lights, const vec3<T>& position,
                           const vec3<T>& normal, int pieces,
                           const LightVisibility& light_visibility = LightVisibility{}) {
    vec3<T> sum = vec3<T>(T(0), T(0), T(0));
    for (int i = 0; i < 6; ++i) {
        sum += strip_irradiance_in_air<T, Scene>(air, habitat_strip(air, lights, i), position, normal, pieces,
                                                 light_visibility);
    }
    return sum;
}

}  // namespace airlight
