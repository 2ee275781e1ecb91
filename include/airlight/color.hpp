#pragma once

#include <airlight/numeric.hpp>
#include <airlight/types.hpp>

namespace airlight {

/// Luminance of a linear Rec. 709 colour, relative to white.
///
///     Y = 0.2126 R + 0.7152 G + 0.0722 B
///
/// Units:    radiance and result in one unit.
/// Shape:    radiance is a spectrum, red, green, blue.
/// Domain:   every finite colour.
/// Accuracy: 3 ulp for colours >= 0 (measured: 1.6).
/// Errors:   none.
/// Source:   ITU-R BT.709, item 3.2.
template <typename T>
T luminance(const vec3<T>& radiance) {
    return T(0.2126L) * radiance.x + T(0.7152L) * radiance.y + T(0.0722L) * radiance.z;
}

/// Exposes a radiance as film does: linear for little light, at most 1 for much.
///
///     1 - exp(-exposure x)
///
/// Units:    radiance times exposure [1]; result [1], in [0, 1].
/// Shape:    radiance is a spectrum.
/// Domain:   radiance >= 0; exposure >= 0.
/// Accuracy: that of one_minus_exp plus one roundoff.
/// Errors:   none.
/// Source:   a saturating response; the form of the CS562 renderer and of Leenman's shader.
template <typename T>
vec3<T> exposed(const vec3<T>& radiance, T exposure) {
    return vec3<T>(one_minus_exp(exposure * radiance.x), one_minus_exp(exposure * radiance.y),
                   one_minus_exp(exposure * radiance.z));
}

/// sRGB code value of one linear channel.
///
/// Units:    linear [1]; result [1].
/// Domain:   linear in [0, 1]; values outside are clamped to it.
/// Accuracy: under 6 ulp where pow is within 1 (measured: 2.4).
/// Errors:   none.
/// Source:   IEC 61966-2-1, sRGB transfer function.
template <typename T>
T srgb_channel_from_linear(T linear) {
    const T x = glm::clamp(linear, T(0), T(1));
    return x <= T(0.0031308L) ? T(12.92L) * x : T(1.055L) * glm::pow(x, T(1) / T(2.4L)) - T(0.055L);
}

/// Linear value of one sRGB channel, the inverse of srgb_channel_from_linear.
///
/// Units:    encoded [1]; result [1].
/// Domain:   encoded in [0, 1]; values outside are clamped to it.
/// Accuracy: under 8 ulp where pow is within 1 (measured: 5.1).
/// Errors:   none.
/// Source:   IEC 61966-2-1, sRGB transfer function.
template <typename T>
T linear_channel_from_srgb(T encoded) {
    const T x = glm::clamp(encoded, T(0), T(1));
    return x <= T(0.04045L) ? x / T(12.92L) : glm::pow((x + T(0.055L)) / T(1.055L), T(2.4L));
}

/// sRGB code values of a linear colour, for a display.
///
/// Units:    linear [1]; result [1].
/// Domain:   channels in [0, 1]; values outside are clamped to it.
/// Accuracy: under 6 ulp where pow is within 1 (measured: 2.4).
/// Errors:   none.
/// Source:   IEC 61966-2-1, sRGB transfer function.
template <typename T>
vec3<T> srgb_from_linear(const vec3<T>& linear) {
    return vec3<T>(srgb_channel_from_linear(linear.x), srgb_channel_from_linear(linear.y),
                   srgb_channel_from_linear(linear.z));
}

/// Linear colour of sRGB code values.
///
/// Units:    encoded [1]; result [1].
/// Domain:   channels in [0, 1]; values outside are clamped to it.
/// Accuracy: under 8 ulp where pow is within 1 (measured: 5.1).
/// Errors:   none.
/// Source:   IEC 61966-2-1, sRGB transfer function.
template <typename T>
vec3<T> linear_from_srgb(const vec3<T>& encoded) {
    return vec3<T>(linear_channel_from_srgb(encoded.x), linear_channel_from_srgb(encoded.y),
                   linear_channel_from_srgb(encoded.z));
}

}  // namespace airlight
