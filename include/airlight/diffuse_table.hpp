#pragma once

#include <airlight/diffuse_light.hpp>
#include <airlight/sky_irradiance.hpp>
#include <airlight/table_mapping.hpp>

namespace airlight {

/// The sun's cosine at which the diffuse table has spent half of each side's width, nearly [1].
template <typename T>
inline constexpr T diffuse_table_dusk = T(0.15L);

/// Where the diffuse table is read: x by the sun's height, densest at dusk, y by altitude, densest at the
/// ground.
///
///     x = (1 + s) / 2,   y = sqrt(altitude / top_altitude),   s = bent_sun(mu_s, diffuse_table_dusk)
///
/// Units:    altitude [L]; mu_s [1], cosine between the sun and the vertical; result [1], in [0, 1].
/// Domain:   every altitude and cosine, see table_altitude; width and height >= 1.
/// Accuracy: 8 roundoffs.
/// Errors:   none.
/// Source:   chosen: light from all sides changes most about sunset and low in the air.
template <typename T>
vec2<T> diffuse_table_uv(const Atmosphere<T>& atmosphere, T altitude, T mu_s, int width, int height) {
    const T x = T(0.5) + T(0.5) * bent_sun(table_cosine(mu_s), diffuse_table_dusk<T>);
    const T y = glm::sqrt(share_of(table_altitude(atmosphere, altitude), atmosphere.top_altitude));
    return vec2<T>(texture_from_unit(x, width), texture_from_unit(y, height));
}

/// The inverse of diffuse_table_uv.
///
/// Units:    uv [1]; width and height in texels.
/// Domain:   every uv; width and height >= 1.
/// Accuracy: 16 roundoffs of the size.
/// Errors:   none.
/// Source:   diffuse_table_uv.
template <typename T>
AltitudeCosine<T> diffuse_table_parameters(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int width,
                                           int height) {
    const T bent = T(2) * unit_from_texture(uv.x, width) - T(1);
    const T y = unit_from_texture(uv.y, height);
    return AltitudeCosine<T>{y * y * atmosphere.top_altitude, sun_from_bent(bent, diffuse_table_dusk<T>)};
}

/// The least mean radiance that the diffuse table tells from darkness, and its logarithm [1/sr, 1].
template <typename T>
inline constexpr T diffuse_table_dark = T(1e-30L);

/// A spectrum's logarithm, of what is too dark that of diffuse_table_dark.
///
/// Units:    radiance [1/sr] or [1]; result [1].
/// Domain:   radiance >= 0.
/// Accuracy: that of log.
/// Errors:   none.
/// Source:   none.
template <typename T>
vec3<T> log_of_light(const vec3<T>& radiance) {
    const T dark = diffuse_table_dark<T>;
    return glm::log(glm::max(radiance, vec3<T>(dark, dark, dark)));
}

/// DiffuseLight as seven texels of a texture that may be of half precision: the mean's logarithm, the rest in
/// terms of the mean.
template <typename T>
struct DiffuseTexels {
    vec4<T> mean;      ///< [1] xyz: log of the mean; w: away, red
    vec4<T> vertical;  ///< [1] xyz: vertical; w: away, green
    vec4<T> slanted;   ///< [1] xyz: slanted; w: away, blue
    vec4<T> across;    ///< [1] xyz: across; w: aside, red
    vec4<T> up;        ///< [1] xyz: aerosol_up; w: aside, green
    vec4<T> down;      ///< [1] xyz: aerosol_down; w: aside, blue
    vec4<T> sunward;   ///< [1] xyz: aerosol_sunward; w: unused
};

/// DiffuseLight to texels.
///
/// Twilight is a millionth of noon: its logarithm survives half precision and linear filtering, and so do
/// ratios that stay near 1.
///
/// Units:    light [1/sr]; result [1].
/// Domain:   light of an airlight table, mean >= 0.
/// Accuracy: that of log and a division.
/// Errors:   a mean below diffuse_table_dark counts as dark.
/// Source:   chosen.
template <typename T>
DiffuseTexels<T> packed_diffuse_light(const DiffuseLight<T>& light) {
    const T dark = diffuse_table_dark<T>;
    const vec3<T> mean = log_of_light(light.mean);
    const vec3<T> unit = T(1) / glm::max(light.mean, vec3<T>(dark, dark, dark));
    const vec3<T> vertical = light.vertical * unit;
    const vec3<T> slanted = light.slanted * unit;
    const vec3<T> across = light.across * unit;
    const vec3<T> up = light.aerosol_up * unit;
    const vec3<T> down = light.aerosol_down * unit;
    const vec3<T> sunward = light.aerosol_sunward * unit;
    const vec3<T> away = light.aerosol_away * unit;
    const vec3<T> aside = light.aerosol_aside * unit;
    return DiffuseTexels<T>{vec4<T>(mean.x, mean.y, mean.z, away.x),
                            vec4<T>(vertical.x, vertical.y, vertical.z, away.y),
                            vec4<T>(slanted.x, slanted.y, slanted.z, away.z),
                            vec4<T>(across.x, across.y, across.z, aside.x),
                            vec4<T>(up.x, up.y, up.z, aside.y),
                            vec4<T>(down.x, down.y, down.z, aside.z),
                            vec4<T>(sunward.x, sunward.y, sunward.z, T(0))};
}

/// The inverse of packed_diffuse_light, also of texels that a texture has interpolated.
///
/// Units:    texels [1]; result [1/sr].
/// Domain:   texels of packed_diffuse_light or between such.
/// Accuracy: that of exp.
/// Errors:   none.
/// Source:   packed_diffuse_light.
template <typename T>
DiffuseLight<T> unpacked_diffuse_light(const DiffuseTexels<T>& texels) {
    const vec3<T> mean = glm::exp(vec3<T>(texels.mean.x, texels.mean.y, texels.mean.z));
    return DiffuseLight<T>{mean,
                           mean * vec3<T>(texels.vertical.x, texels.vertical.y, texels.vertical.z),
                           mean * vec3<T>(texels.slanted.x, texels.slanted.y, texels.slanted.z),
                           mean * vec3<T>(texels.across.x, texels.across.y, texels.across.z),
                           mean * vec3<T>(texels.up.x, texels.up.y, texels.up.z),
                           mean * vec3<T>(texels.down.x, texels.down.y, texels.down.z),
                           mean * vec3<T>(texels.sunward.x, texels.sunward.y, texels.sunward.z),
                           mean * vec3<T>(texels.mean.w, texels.vertical.w, texels.slanted.w),
                           mean * vec3<T>(texels.across.w, texels.up.w, texels.down.w)};
}

/// SkyIrradiance as three texels of such a texture.
template <typename T>
struct IrradianceTexels {
    vec4<T> down;     ///< [1] xyz: log of down
    vec4<T> up;       ///< [1] xyz: log of up
    vec4<T> sunward;  ///< [1] xyz: sunward over down + up
};

/// SkyIrradiance to texels.
///
/// Units:    sky [1]; result [1].
/// Domain:   sky of an airlight table, down and up >= 0.
/// Accuracy: that of log and a division.
/// Errors:   irradiance below diffuse_table_dark counts as dark.
/// Source:   packed_diffuse_light.
template <typename T>
IrradianceTexels<T> packed_sky_irradiance(const SkyIrradiance<T>& sky) {
    const T dark = diffuse_table_dark<T>;
    const vec3<T> down = log_of_light(sky.down);
    const vec3<T> up = log_of_light(sky.up);
    const vec3<T> sunward = sky.sunward / glm::max(sky.down + sky.up, vec3<T>(dark, dark, dark));
    return IrradianceTexels<T>{vec4<T>(down.x, down.y, down.z, T(0)), vec4<T>(up.x, up.y, up.z, T(0)),
                               vec4<T>(sunward.x, sunward.y, sunward.z, T(0))};
}

/// The inverse of packed_sky_irradiance, also of texels that a texture has interpolated.
///
/// Units:    texels [1]; result [1].
/// Domain:   texels of packed_sky_irradiance or between such.
/// Accuracy: that of exp.
/// Errors:   none.
/// Source:   packed_sky_irradiance.
template <typename T>
SkyIrradiance<T> unpacked_sky_irradiance(const IrradianceTexels<T>& texels) {
    const vec3<T> down = glm::exp(vec3<T>(texels.down.x, texels.down.y, texels.down.z));
    const vec3<T> up = glm::exp(vec3<T>(texels.up.x, texels.up.y, texels.up.z));
    const vec3<T> sunward = vec3<T>(texels.sunward.x, texels.sunward.y, texels.sunward.z);
    return SkyIrradiance<T>{down, up, sunward * (down + up)};
}

}  // namespace airlight
