#pragma once

#include <airlight/habitat.hpp>
#include <airlight/strip_phases.hpp>

namespace airlight {

/// Hook: the share of the light from `light_position` that reaches `position`, in [0, 1].
struct AlwaysSeen {
    template <typename T>
    constexpr T operator()([[maybe_unused]] const vec3<T>& light_position,
                           [[maybe_unused]] const vec3<T>& position) const {
        return T(1);
    }
};

/// Light that a habitat's air at a place turns into a view ray from one direction, per unit of that
/// direction's irradiance and of way.
///
///     density (rayleigh_scattering p_R + mie_scattering p_M)
///
/// Units:    density relative to the wall's and cos_theta [1]; result [1/(L sr)].
/// Shape:    the result is a spectrum.
/// Domain:   cos_theta in [-1, 1], 1 is light that keeps its direction.
/// Accuracy: that of the phase functions.
/// Errors:   none.
/// Source:   definition of the phase function.
template <typename T, typename Scene = DefaultScene>
vec3<T> habitat_scattering(const HabitatAir<T>& air, T density, T cos_theta) {
    vec3<T> scattered = air.rayleigh_scattering * rayleigh_phase(cos_theta);
    if constexpr (Scene::mie) {
        scattered += air.mie_scattering * mie_phase<T, Scene>(cos_theta, air.mie_g);
    }
    return density * scattered;
}

/// Share of the light of one point of a lamp that reaches a place: past the air and what the hook hides.
///
///     t V
///
/// Units:    light_position and position [L]; result [1], in [0, 1].
/// Shape:    the result is a spectrum.
/// Domain:   that of habitat_column.
/// Accuracy: that of habitat_transmittance.
/// Errors:   none.
/// Source:   definition.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> light_reaching(const HabitatAir<T>& air, const vec3<T>& light_position, const vec3<T>& position,
                       const LightVisibility& light_visibility = LightVisibility{}) {
    return light_visibility(light_position, position) *
           habitat_transmittance<T, Scene>(air, light_position, position);
}

/// Cosine between a ray and the light of a strip's point.
///
/// Units:    to_light [L], from the place to the point; direction a unit vector, away from the eye; result
///           [1], 1 is light that keeps its direction.
/// Domain:   view of strip_view.
/// Accuracy: 8 roundoffs.
/// Errors:   none; on the strip too within [-1, 1].
/// Source:   definition.
template <typename T>
T strip_cosine(const StripView<T>& view, const vec3<T>& to_light, const vec3<T>& direction) {
    const T way = glm::max(glm::sqrt(dot_product(to_light, to_light)), view.distance);
    return glm::clamp(dot_product(to_light, direction) / way, T(-1), T(1));
}

/// The air as the points of a strip should meet it: with scattering coefficients that make the mean of the
/// phase functions over the points the one over the whole rectangle, as far as the place is near.
///
///     coefficient (1 + nearness (mean of strip_phases / mean over the points - 1))
///
/// Units:    position [L]; direction a unit vector, away from the eye.
/// Domain:   that of strip_view; pieces >= 1.
/// Accuracy: that of strip_phases.
/// Errors:   with pieces below 1, without a solid angle, and for phase_fog's aerosol as it was.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene>
HabitatAir<T> air_beside_strip(const HabitatAir<T>& air, const LinearLight<T>& light,
                               const StripView<T>& view, const vec3<T>& position, const vec3<T>& direction,
                               int pieces) {
    HabitatAir<T> beside = air;
    const T nearness = strip_nearness(view, light.width);
    if (nearness <= T(0) || view.solid_angle <= T(0) || pieces < 1) {
        return beside;
    }
    T rayleigh = T(0);
    T mie = T(0);
    for (int piece = 0; piece < pieces; ++piece) {
        for (int i = 0; i < 4; ++i) {
            const T share = (T(piece) + gauss_4_positions<T>[i]) / T(pieces);
            const T cos_theta = strip_cosine(view, strip_point(view, share), direction);
            rayleigh += gauss_4_weights<T>[i] * rayleigh_phase(cos_theta);
            if constexpr (Scene::mie && Scene::mie_phase != phase_fog) {
                mie += gauss_4_weights<T>[i] * mie_phase<T, Scene>(cos_theta, air.mie_g);
            }
        }
    }
    const StripPhases<T> whole =
        strip_phases<T, Scene>(light, position, direction, view.solid_angle, air.mie_g);
    beside.rayleigh_scattering *= T(1) + nearness * (whole.rayleigh * T(pieces) / rayleigh - T(1));
    if constexpr (Scene::mie && Scene::mie_phase != phase_fog) {
        beside.mie_scattering *= T(1) + nearness * (whole.mie * T(pieces) / mie - T(1));
    }
    return beside;
}

/// Light of a strip that air at a place turns into a view ray, per unit of way, with its phase functions.
///
///     density integral over the strip's solid angle of (rayleigh_scattering p_R + mie_scattering p_M) L t V
///
/// The rule of Gauss and Legendre with 4 points of the strip's line, evenly over its solid angle, once for
/// each of the `pieces`; within 8 widths with the phase functions of air_beside_strip.
///
/// Units:    position [L]; direction a unit vector, away from the eye; result as radiance per L.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_view and habitat_column; pieces >= 1.
/// Accuracy: 0.24 % in 95 % of places within 4 widths, 0.35 % further off, with 2 pieces half that; a fifth
///           at most, where the ray looks along a strip over 8 widths off.
/// Errors:   none; with pieces below 1, 0.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> strip_source(const HabitatAir<T>& air, const LinearLight<T>& light, const vec3<T>& position,
                     const vec3<T>& direction, int pieces,
                     const LightVisibility& light_visibility = LightVisibility{}) {
    const StripView<T> view = strip_view(light, position);
    vec3<T> sum = vec3<T>(T(0), T(0), T(0));
    if (view.span <= T(0)) {
        return sum;
    }
    const T density = habitat_density(air, position);
    const HabitatAir<T> beside = air_beside_strip<T, Scene>(air, light, view, position, direction, pieces);
    for (int piece = 0; piece < pieces; ++piece) {
        for (int i = 0; i < 4; ++i) {
            const T share = (T(piece) + gauss_4_positions<T>[i]) / T(pieces);
            const vec3<T> to_light = strip_point(view, share);
            const T cos_theta = strip_cosine(view, to_light, direction);
            const vec3<T> reaching =
                light_reaching<T, Scene>(air, position + to_light, position, light_visibility);
            sum +=
                gauss_4_weights<T>[i] * reaching * habitat_scattering<T, Scene>(beside, density, cos_theta);
        }
    }
    return light.radiance * sum * (view.solid_angle / T(pieces > 0 ? pieces : 1));
}

/// Mean radiance over all directions that a strip of light gives a place, past the air between.
///
///     1 / (4 pi) integral over the strip's solid angle of L t V
///
/// By the same points of the strip as strip_source.
///
/// Units:    position [L]; result as radiance.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_source.
/// Accuracy: 0.2 % in 95 % of places, 0.1 % with 2 pieces.
/// Errors:   those of strip_source.
/// Source:   definition.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> strip_mean_radiance(const HabitatAir<T>& air, const LinearLight<T>& light, const vec3<T>& position,
                            int pieces, const LightVisibility& light_visibility = LightVisibility{}) {
    const StripView<T> view = strip_view(light, position);
    vec3<T> sum = vec3<T>(T(0), T(0), T(0));
    if (view.span <= T(0)) {
        return sum;
    }
    for (int piece = 0; piece < pieces; ++piece) {
        for (int i = 0; i < 4; ++i) {
            const T share = (T(piece) + gauss_4_positions<T>[i]) / T(pieces);
            const vec3<T> light_position = position + strip_point(view, share);
            sum += gauss_4_weights<T>[i] *
                   light_reaching<T, Scene>(air, light_position, position, light_visibility);
        }
    }
    return light.radiance * sum * (isotropic_phase<T>() * view.solid_angle / T(pieces > 0 ? pieces : 1));
}

/// Light that a habitat's air at a place scatters evenly to all sides, per unit of way: as if its phase
/// functions were isotropic.
///
/// Units:    position [L]; mean_radiance as the result times L.
/// Shape:    mean_radiance and the result are spectra.
/// Domain:   that of habitat_density.
/// Accuracy: that of habitat_density; what the phase functions would have made of it is not counted.
/// Errors:   none.
/// Source:   Rama, equation of J_LV.
template <typename T, typename Scene = DefaultScene>
vec3<T> isotropic_source(const HabitatAir<T>& air, const vec3<T>& position, const vec3<T>& mean_radiance) {
    vec3<T> scattering = air.rayleigh_scattering;
    if constexpr (Scene::mie) {
        scattering += air.mie_scattering;
    }
    return habitat_density(air, position) * (scattering * mean_radiance);
}

/// Where a ray is nearest to a strip of light, counted along the ray.
///
/// Units:    eye [L]; direction a unit vector; distance and result [L].
/// Domain:   distance >= 0, finite.
/// Accuracy: 64 roundoffs of the way to the strip over the sine between ray and strip; a bad answer costs
///           digits of strip_scattering, not light.
/// Errors:   none; within [0, distance].
/// Source:   closest points of two segments.
template <typename T>
T nearest_to_strip(const LinearLight<T>& light, const vec3<T>& eye, const vec3<T>& direction, T distance) {
    const vec3<T> to_eye = eye - light.centre;
    const T parallel = dot_product(direction, light.along);
    const T sine2 = T(1) - parallel * parallel;
    const T eye_along = dot_product(to_eye, light.along);
    const T eye_before = dot_product(to_eye, direction);
    const T free_nearest = sine2 > T(0) ? (parallel * eye_along - eye_before) / sine2 : T(0);
    const T ray_at = glm::clamp(free_nearest, T(0), distance);
    const T strip_at = glm::clamp(eye_along + ray_at * parallel, -light.half_length, light.half_length);
    return glm::clamp(strip_at * parallel - eye_before, T(0), distance);
}

/// Inverse of the hyperbolic sine.
///
///     log(x + sqrt(1 + x^2))
///
/// Units:    x and result [1].
/// Domain:   x >= 0; x^2 finite.
/// Accuracy: relative 5e-8 by the series below 0.1, plus 24 roundoffs.
/// Errors:   x < 0 loses its digits.
/// Source:   Taylor's series where the logarithm has none.
template <typename T>
T area_sine(T x) {
    if (x < T(0.1)) {
        const T x2 = x * x;
        return x * (T(1) - x2 * (T(0.166666666666666666666666666666666667L) - T(0.075) * x2));
    }
    return glm::log(x + glm::sqrt(T(1) + x * x));
}

/// A sample of a ray whose light peaks at one place.
template <typename T>
struct PeakNode {
    T t;       ///< [L] from the eye
    T weight;  ///< [L] of the ray that it stands for
};

/// Samples of a ray whose light falls off from a peak as 1 / sqrt(width^2 + (t - peak)^2): the area sines of
/// their ways from it are the Scene::nodes points of Gauss and Legendre.
///
/// Units:    all [L]; i counts the nodes from the eye.
/// Domain:   peak in [0, distance]; width > 0, or distance = 0; i from 0 to Scene::nodes - 1.
/// Accuracy: 32 roundoffs of distance.
/// Errors:   none; without distance a node has no weight.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene>
PeakNode<T> peak_node(T peak, T width, T distance, int i) {
    if (distance <= T(0)) {
        return PeakNode<T>{T(0), T(0)};
    }
    const T before = area_sine(peak / width);
    const T reach = before + area_sine((distance - peak) / width);
    const T v = reach * gauss_position<T, Scene>(i) - before;
    const T grown = glm::exp(glm::abs(v));
    const T shrunk = T(1) / grown;
    const T away = T(0.5) * width * (grown - shrunk);
    const T weight = T(0.5) * width * (grown + shrunk) * reach * gauss_weight<T, Scene>(i);
    return PeakNode<T>{glm::clamp(v < T(0) ? peak - away : peak + away, T(0), distance), weight};
}

/// How far a strip of light is from a place on a ray, as the width of a peak of the ray's light: no less than
/// a quarter of the strip's width, for over the strip the light hardly varies, and no less than a
/// ten-thousandth of the ray, so that no node is lost on a light that the ray meets.
///
/// Units:    all [L].
/// Domain:   that of strip_view.
/// Accuracy: 32 roundoffs of the way from the strip's centre.
/// Errors:   none.
/// Source:   docs/theory/linear_light.md.
template <typename T>
T peak_width(const LinearLight<T>& light, const vec3<T>& position, T distance) {
    const StripView<T> there = strip_view(light, position);
    const T beyond = glm::max(there.begin, T(0));
    const T gap = glm::sqrt(there.distance * there.distance + beyond * beyond);
    return glm::max(glm::max(gap, T(0.25) * light.width), T(1e-4L) * distance);
}

/// How a ray comes past a strip of light.
template <typename T>
struct StripApproach {
    T nearest;    ///< [L] from the eye to where the ray is nearest to the strip
    T width;      ///< [L] of the peak of the ray's light there
    bool ends;    ///< the ray flies past an end of the strip, closely
    T end;        ///< [L] from the eye to where it does
    T end_width;  ///< [L] over which the light breaks off there
};

/// How a ray comes past a strip: where its light peaks, and where it breaks off.
///
/// Along a ray at the angle a to the strip the light falls off over the gap divided by sin a, and breaks off
/// over the gap itself where the ray crosses the plane through an end of the strip. Ends that are further
/// than a sixteenth of the ray make no break that nodes would miss.
///
/// Units:    eye [L]; direction a unit vector; distance [L].
/// Domain:   distance >= 0, finite.
/// Accuracy: nearest that of nearest_to_strip; end 32 roundoffs of the way to the strip over the cosine
/// between
///           ray and strip.
/// Errors:   none; both places within [0, distance]. Past no end, the end is 0.
/// Source:   docs/theory/linear_light.md.
template <typename T>
StripApproach<T> strip_approach(const LinearLight<T>& light, const vec3<T>& eye, const vec3<T>& direction,
                                T distance) {
    const T nearest = nearest_to_strip(light, eye, direction, distance);
    const vec3<T> slope = glm::cross(light.along, direction);
    const T sine = glm::max(glm::sqrt(dot_product(slope, slope)), T(0.01L));
    const T parallel = dot_product(direction, light.along);
    const T eye_along = dot_product(eye - light.centre, light.along);
    const T least_width = glm::max(T(0.25) * light.width, T(1e-4L) * distance);  // as in peak_width
    bool ends = false;
    T end = T(0);
    T end_width = T(0.0625) * distance;
    for (int i = 0; i < 2; ++i) {
        const T way = (i == 0 ? -light.half_length : light.half_length) - eye_along;
        if (glm::abs(way) < glm::abs(parallel) * distance && parallel * way > T(0)) {
            const T t = way / parallel;
            const vec3<T> aside = glm::cross(light.along, eye + t * direction - light.centre);
            const T gap = glm::max(glm::sqrt(dot_product(aside, aside)), least_width);
            if (gap < end_width) {
                ends = true;
                end = t;
                end_width = gap;
            }
        }
    }
    return StripApproach<T>{nearest, peak_width(light, eye + nearest * direction, distance) / sine, ends, end,
                            end_width};
}

/// A stretch of a ray whose light peaks at one place.
template <typename T>
struct PeakStretch {
    T begin;   ///< [L] from the eye
    T extent;  ///< [L]
    T peak;    ///< [L] from the begin to the peak
    T width;   ///< [L] of the peak
};

/// The stretches before (i = 0) and behind the end of a strip that a ray flies past. The one with the place
/// that is nearest to the strip has its peak there, the other at the end.
///
/// Units:    all [L].
/// Domain:   approach of strip_approach for this distance; i = 1 where the ray flies past an end.
/// Accuracy: 2 roundoffs of distance.
/// Errors:   none; past no end, the stretch before it is the ray.
/// Source:   docs/theory/linear_light.md.
template <typename T>
PeakStretch<T> peak_stretch(const StripApproach<T>& approach, T distance, int i) {
    const T begin = i == 0 ? T(0) : approach.end;
    const T extent = (i == 0 && approach.ends ? approach.end : distance) - begin;
    const bool here = approach.ends ? (approach.nearest <= approach.end) == (i == 0) : i == 0;
    return PeakStretch<T>{begin, extent, glm::clamp(approach.nearest - begin, T(0), extent),
                          here ? approach.width : approach.end_width};
}

/// Light of a strip that the air between the eye and a surface scatters towards the eye, once scattered.
///
///     integral_0^distance t(eye, q) strip_source(q) dq
///
/// By the nodes of peak_node, on each of the stretches of peak_stretch.
///
/// Units:    eye [L]; direction a unit vector; distance [L]; result as radiance.
/// Shape:    the result is a spectrum.
/// Domain:   that of strip_source; distance finite.
/// Accuracy: 0.03 % for 95 % of eyes 4 widths off the strip, 0.23 % at most; closer 0.3 % and 5 %.
/// Errors:   none; 0 for a distance of 0.
/// Source:   docs/theory/linear_light.md.
template <typename T, typename Scene = DefaultScene, typename LightVisibility = AlwaysSeen>
vec3<T> strip_scattering(const HabitatAir<T>& air, const LinearLight<T>& light, const vec3<T>& eye,
                         const vec3<T>& direction, T distance, int pieces,
                         const LightVisibility& light_visibility = LightVisibility{}) {
    vec3<T> sum = vec3<T>(T(0), T(0), T(0));
    const StripApproach<T> approach = strip_approach(light, eye, direction, distance);
    for (int k = 0; k < 2; ++k) {
        const PeakStretch<T> stretch = peak_stretch(approach, distance, k);
        if (k == 0 || approach.ends) {
            for (int i = 0; i < Scene::nodes; ++i) {
                const PeakNode<T> node = peak_node<T, Scene>(stretch.peak, stretch.width, stretch.extent, i);
                const vec3<T> position = eye + (stretch.begin + node.t) * direction;
                sum += node.weight * habitat_transmittance<T, Scene>(air, eye, position) *
                       strip_source<T, Scene>(air, light, position, direction, pieces, light_visibility);
            }
        }
    }
    return sum;
}

}  // namespace airlight
