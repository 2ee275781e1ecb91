#pragma once

// What passes to space from a table of 64 x 32 texels. The table does not hold transmittances: they change by
// powers of ten between texels. It holds by how much a guess at Chapman's function is off, a few percent that
// change slowly, so that linear filtering, half precision and a GPU's coarse filter weights all do.

#include <airlight/sun_column.hpp>
#include <airlight/table_mapping.hpp>
#include <airlight/transmittance.hpp>

namespace airlight {

/// A guess at chapman: exact along the horizon, right for a vertical ray through a thin shell.
///
///     2 / (mu + sqrt(mu^2 + 8 / (pi (x + 3 / 4))))
///
/// Units:    x = radius / scale height [1]; mu [1]; result [1].
/// Domain:   x >= 0; mu in [0, 1].
/// Accuracy: 6 % too high, 1.3 % too low at most from x = 50 on (measured: 5.8 %, 1.2 %).
/// Errors:   none; an infinite x gives 1 / mu, which is infinite along the horizon.
/// Source:   the upper bound of the error function in NIST Digital Library of Mathematical Functions, 7.8.2;
///           3 / 4 as in exponential_from_perigee.
template <typename T>
T slant_guess(T x, T mu) {
    return T(2) / (mu + glm::sqrt(mu * mu + T(8) / (pi<T> * (x + T(0.75)))));
}

/// The cosine that stands in the middle of a table of slants.
///
/// Units:    result [1].
/// Domain:   that of Atmosphere.
/// Accuracy: 3 roundoffs.
/// Errors:   none; 0 where both scale heights are.
/// Source:   chosen: the cosine at which Chapman's function bends is about the root of height over radius.
template <typename T>
T slant_scale(const Atmosphere<T>& atmosphere) {
    return glm::sqrt(glm::max(atmosphere.rayleigh_scale_height, atmosphere.mie_scale_height) /
                     atmosphere.ground_radius);
}

/// Where a table of slants is read: x is the direction, along the horizon 0 and vertical 1, y the altitude.
///
///     x = mu (1 + s) / (mu + s),   y = altitude / top_altitude,   s = slant_scale
///
/// Units:    altitude [L]; mu [1]; width and height in texels; result [1], in [0, 1].
/// Domain:   every altitude, see table_altitude; mu in [0, 1]; width and height >= 1.
/// Accuracy: 6 roundoffs.
/// Errors:   none; a mu below 0 counts as 0.
/// Source:   slant_scale.
template <typename T>
vec2<T> slant_uv(const Atmosphere<T>& atmosphere, T altitude, T mu, int width, int height) {
    const T scale = slant_scale(atmosphere);
    const T upward = glm::max(mu, T(0));
    const T x = share_of(upward * (T(1) + scale), upward + scale);
    const T y = share_of(table_altitude(atmosphere, altitude), atmosphere.top_altitude);
    return vec2<T>(texture_from_unit(x, width), texture_from_unit(y, height));
}

/// The inverse of slant_uv.
///
///     mu = s x / (1 + s - x)
///
/// Units:    uv [1]; width and height in texels.
/// Domain:   every uv; width and height >= 1.
/// Accuracy: 6 roundoffs of the size.
/// Errors:   none; where both scale heights are 0 every direction but the horizontal one lies at x = 1, which
///           then stands for the vertical one.
/// Source:   as slant_uv.
template <typename T>
AltitudeCosine<T> slant_parameters(const Atmosphere<T>& atmosphere, const vec2<T>& uv, int width,
                                   int height) {
    const T scale = slant_scale(atmosphere);
    const T x = unit_from_texture(uv.x, width);
    const T mu = x < T(1) ? share_of(scale * x, (T(1) - x) + scale) : T(1);
    return AltitudeCosine<T>{unit_from_texture(uv.y, height) * atmosphere.top_altitude, mu};
}

/// What a texel of a table of slants holds: by how much Chapman's function exceeds slant_guess, for the
/// molecules (x) and the aerosol (y), as shares of the guess.
///
/// Units:    altitude [L]; mu [1]; result [1].
/// Domain:   altitude in [0, top_altitude]; mu in [0, 1].
/// Accuracy: that of chapman.
/// Errors:   none; in [-0.06, 0.013] from radius / scale height = 50 on.
/// Source:   chapman, slant_guess.
template <typename T, typename Scene = DefaultScene>
vec2<T> slant_texel(const Atmosphere<T>& atmosphere, T altitude, T mu) {
    const Layers<T> layers = layers_of<T, Scene>(atmosphere);
    const T radius = atmosphere.ground_radius + altitude;
    const T sine = safe_sqrt((T(1) - mu) * (T(1) + mu));
    const T x = radius * layers.rayleigh_inverse;
    const T rayleigh = chapman(x, mu, sine) / slant_guess(x, mu) - T(1);
    T mie = T(0);
    if constexpr (Scene::mie) {
        const T y = radius * layers.mie_inverse;
        mie = chapman(y, mu, sine) / slant_guess(y, mu) - T(1);
    }
    return vec2<T>(rayleigh, mie);
}

/// Hook: a table of slants at texture coordinates. Without one the guess stands, up to 6 % too high.
struct NoSlantTable {
    template <typename T>
    vec2<T> operator()([[maybe_unused]] const vec2<T>& uv) const {
        return vec2<T>(T(0), T(0));
    }
};

/// The air from a point to the end of the air, by a table of slants.
///
/// The densities and the ozone come as in column_to_sun, only Chapman's function from the table.
///
/// Units:    altitude [L]; mu [1], cosine to the vertical; width and height of the table in texels;
///           result [L].
/// Domain:   altitude in [0, top_altitude], see table_altitude; mu in [-1, 1].
/// Accuracy: as light sees it, exp of minus the optical depth, with 64 x 32 texels: 2.5e-4 of what passes
///           (measured: 2.0e-4, half precision included); ozone of the Lorentz curve by ozone_to_sun.
/// Errors:   none; ignores the ground.
/// Source:   slant_texel.
template <typename T, typename Scene = DefaultScene, typename SlantTable = NoSlantTable>
Column<T> column_from_slants(const Atmosphere<T>& atmosphere, T altitude, T mu, int width, int height,
                             const SlantTable& slant_table = SlantTable{}) {
    const Layers<T> layers = layers_of<T, Scene>(atmosphere);
    const T above = table_altitude(atmosphere, altitude);
    const T radius = atmosphere.ground_radius + above;
    const T cosine = table_cosine(mu);
    const bool sinks = cosine < T(0);
    const T upward = glm::abs(cosine);
    const LinePoint<T> point = line_towards_sun(above, radius, T(1) / radius, radius * cosine);
    const Density<T> density = layer_density<T, Scene>(layers, above);
    const vec2<T> excess = slant_table(slant_uv(atmosphere, above, upward, width, height));

    const T rayleigh = density.rayleigh * layers.rayleigh_height *
                       slant_guess(radius * layers.rayleigh_inverse, upward) * (T(1) + excess.x);
    T mie = T(0);
    if constexpr (Scene::mie) {
        mie = density.mie * layers.mie_height * slant_guess(radius * layers.mie_inverse, upward) *
              (T(1) + excess.y);
    }
    Column<T> endless = Column<T>{rayleigh, mie, T(0)};
    if (sinks) {
        endless = exponentials_through_perigee<T, Scene>(layers, point, endless);
    }

    // Beyond the top there is no air: what the exponentials have there is guessed and taken off.
    const T top = layers.top_radius;
    const T exit = safe_sqrt((top - point.perigee_radius) * (top + point.perigee_radius)) / top;
    const T slant = slant_guess(top * layers.rayleigh_inverse, exit) / top;
    const T mie_left = glm::max(endless.mie - layers.mie_above * slant, T(0));
    return Column<T>{glm::max(endless.rayleigh - layers.rayleigh_above * slant, T(0)), mie_left,
                     ozone_to_sun<T, Scene>(layers, atmosphere.ground_radius, point, sinks)};
}

/// Share of light that reaches a point from a far source, by a table of slants; 0 where the planet hides it.
///
/// Units:    altitude [L]; mu [1], cosine between the source and the vertical; width and height of the table
///           in texels; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   that of column_from_slants.
/// Accuracy: that of column_from_slants.
/// Errors:   none; without Scene::planet_shadow the ground is ignored.
/// Source:   Beer's law.
template <typename T, typename Scene = DefaultScene, typename SlantTable = NoSlantTable>
vec3<T> transmittance_from_slants(const Atmosphere<T>& atmosphere, T altitude, T mu, int width, int height,
                                  const SlantTable& slant_table = SlantTable{}) {
    if constexpr (Scene::planet_shadow) {
        if (behind_planet(atmosphere.ground_radius, altitude, mu)) {
            return vec3<T>(T(0), T(0), T(0));
        }
    }
    const Column<T> air =
        column_from_slants<T, Scene, SlantTable>(atmosphere, altitude, mu, width, height, slant_table);
    return glm::exp(-column_optical_depth<T, Scene>(atmosphere, air));
}

}  // namespace airlight
