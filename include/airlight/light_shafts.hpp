#pragma once

#include <airlight/ray_legs.hpp>

namespace airlight {

/// A view ray made ready for shadows in its air.
///
/// What the planet's own shadow covers is taken out of it: places on it are counted along what is left, its
/// lit length.
template <typename T>
struct ShaftRay {
    RayLegs<T> legs;    ///< of the ray
    T lit_length;       ///< [L] of the stretch in the air, less what the planet's shadow covers
    T night;            ///< [L] lit length before the planet's shadow; beyond the ray where none is behind it
    T night_length;     ///< [L] of the planet's shadow, where the ray comes out of it again
    T near_root;        ///< [1] root of the share of the lit length before where its pieces are shortest
    T far_root;         ///< [1] root of the share behind that
    vec3<T> brightest;  ///< [1/(L sr)] scattered towards the eye by air of density 1 in full sunlight
    vec3<T> most;       ///< [1/sr] the most that the ray can scatter
};

/// One piece of a shaft ray's lit length and the source of light in it: brightest exp(-depth), with a cubic
/// between the ends for the depth.
template <typename T>
struct ShaftPiece {
    T begin;             ///< [L] of its near end
    T extent;            ///< [L] its length
    vec3<T> near_depth;  ///< [1] source_depth at its near end
    vec3<T> far_depth;   ///< [1] the same at its far end
    vec3<T> near_slope;  ///< [1] of the depth over the piece's length, at its near end
    vec3<T> far_slope;   ///< [1] the same at its far end
};

/// The optical depth of a whole ray, however short: its ends' densities take the place of a difference of
/// columns that has no digits left.
///
/// Units:    result [1].
/// Shape:    the result is a spectrum.
/// Domain:   legs of ray_legs.
/// Accuracy: that of depth_of_legs; of a ray shorter than a hundredth of a layer's scale height 1e-5 of it.
/// Errors:   none; rounding below 0 counts as 0.
/// Source:   leg_offset; the trapezoid rule.
template <typename T, typename Scene = DefaultScene>
vec3<T> depth_of_any_legs(const Atmosphere<T>& atmosphere, const LitRay<T>& ray, const RayLegs<T>& legs) {
    const T extent = ray.air.extent;
    Column<T> passed = column_sum(leg_offset(legs, true), T(-1), legs.last.outwards);
    if (extent < T(0.01L) * ray.layers.rayleigh_height) {
        passed.rayleigh = T(0.5) * extent * (legs.start.density.rayleigh + legs.last.density.rayleigh);
    }
    if constexpr (Scene::mie) {
        if (extent < T(0.01L) * ray.layers.mie_height) {
            passed.mie = T(0.5) * extent * (legs.start.density.mie + legs.last.density.mie);
        }
    }
    return glm::max(column_optical_depth<T, Scene>(atmosphere, passed), vec3<T>(T(0), T(0), T(0)));
}

/// A view ray made ready for shadows in its air.
///
/// Its pieces are shortest at the eye. From an eye so high that there is hardly any air about it, where the
/// ray comes closest to the ground.
///
/// Units:    those of single_scattering.
/// Domain:   that of single_scattering; ray is lit_ray's, and in the air.
/// Accuracy: that of its parts.
/// Errors:   none.
/// Source:   ray_legs, shadow_span, most_scattered.
template <typename T, typename Scene = DefaultScene>
ShaftRay<T> shaft_ray(const Atmosphere<T>& atmosphere, const LitRay<T>& ray) {
    const AirRay<T> air = ray.air;
    const RayLegs<T> legs = ray_legs<T, Scene>(atmosphere, ray);
    LineSpan<T> dark = LineSpan<T>{T(0), T(0)};
    if constexpr (Scene::planet_shadow) {
        dark = shadow_span(atmosphere.ground_radius, air.perigee_altitude, ray.sun, T(0));
    }
    const T extent = air.extent;
    const T begin = glm::clamp(dark.begin - air.along, T(0), extent);
    const T end = glm::clamp(dark.end - air.along, T(0), extent);
    const bool dawns = dark.begin < dark.end && dark.end - air.along < extent;
    const T lit_length = glm::max(extent - (end - begin), T(0));
    const T thinner = legs.start.density.rayleigh / glm::max(legs.turned.density.rayleigh, smallest_share<T>);
    const T turn = glm::min(legs.turn, begin) + glm::max(legs.turn - end, T(0));
    // The thousandth of the whole keeps the share defined where all of the ray is dark.
    const T focus = glm::clamp(T(1) - T(4) * thinner, T(0), T(1)) * (turn / (lit_length + T(1e-3L) * extent));
    const vec3<T> depth = depth_of_any_legs<T, Scene>(atmosphere, ray, legs);
    return ShaftRay<T>{legs,
                       lit_length,
                       dawns ? begin : T(2) * extent,
                       dawns ? end - begin : T(0),
                       glm::sqrt(focus),
                       glm::sqrt(T(1) - focus),
                       ray.rayleigh_source + ray.mie_source,
                       most_scattered<T, Scene>(atmosphere, ray.sun.cos_theta, depth, glm::exp(-depth))};
}

/// How far from the start of the ray's air a place of its lit length is.
///
/// Units:    lit and result [L].
/// Domain:   lit from 0 to shaft.lit_length.
/// Accuracy: 1 ulp.
/// Errors:   none.
/// Source:   none.
template <typename T>
T shaft_distance(const ShaftRay<T>& shaft, T lit) {
    return lit + (lit >= shaft.night ? shaft.night_length : T(0));
}

/// Where the pieces of a lit length end, as a share of it: their lengths are as 1, 3, 5, ... on either side
/// of where they are shortest, for most eyes the near end.
///
///     near_root^2 + s |s|,   s = (near_root + far_root) i / pieces - near_root
///
/// Units:    result [1].
/// Domain:   i from 0 to pieces; pieces >= 1.
/// Accuracy: 4 roundoffs.
/// Errors:   none.
/// Source:   chosen: the air near an eye in it is worth most.
template <typename T>
T shaft_piece_end(const ShaftRay<T>& shaft, int i, int pieces) {
    const T x = T(i) / T(pieces);
    const T s = x * shaft.far_root - (T(1) - x) * shaft.near_root;
    return shaft.near_root * shaft.near_root + s * glm::abs(s);
}

/// Minus the logarithm of a share, at most 46.
///
/// Units:    part and whole in one unit; result [1].
/// Domain:   0 <= part, whole.
/// Accuracy: 2 roundoffs of max(result, 1).
/// Errors:   none; no part of nothing counts as nothing.
/// Source:   Beer's law.
template <typename T>
T depth_of_share(T part, T whole) {
    const T share = whole > T(0) ? part / whole : T(0);
    return -glm::log(glm::max(share, smallest_share<T>));
}

/// How much dimmer the source of light is at a place of a ray than it could be: by thinner air, on the way
/// of sunlight to the place and on the way from there to the eye.
///
///     source = brightest exp(-source_depth)   [1/(L sr)]
///
/// Units:    lit [L]; result [1].
/// Shape:    the result is a spectrum.
/// Domain:   shaft is the ray's shaft_ray; lit from 0 to its lit_length.
/// Accuracy: that of node_radiance.
/// Errors:   none; a source below 1e-20 of the brightest counts as that.
/// Source:   node_radiance.
template <typename T, typename Scene = DefaultScene>
vec3<T> source_depth(const Atmosphere<T>& atmosphere, const LitRay<T>& ray, const ShaftRay<T>& shaft, T lit) {
    const T t = shaft_distance(shaft, lit);
    const T along = ray.air.along + t;
    const T altitude =
        glm::max(altitude_along_ray(atmosphere.ground_radius, ray.air.altitude, ray.air.along, t), T(0));
    const Density<T> density = layer_density<T, Scene>(ray.layers, altitude);
    const bool climbs = along > T(0);
    const vec3<T> source = node_radiance<T, Scene>(atmosphere, ray, leg_offset(shaft.legs, climbs),
                                                   climbs ? T(1) : T(-1), altitude, glm::abs(along), density);
    return vec3<T>(depth_of_share(source.x, shaft.brightest.x), depth_of_share(source.y, shaft.brightest.y),
                   depth_of_share(source.z, shaft.brightest.z));
}

/// A slope for a cubic between two chords' common end, cut so that the cubic stays between its ends.
///
/// Units:    the three in one unit.
/// Shape:    slope, before, after and the result are spectra.
/// Domain:   every slope.
/// Accuracy: exact but for the factor 3.
/// Errors:   none.
/// Source:   Fritsch and Carlson, Monotone piecewise cubic interpolation (1980): slopes within three times
///           both chords', and 0 where these differ in sign.
template <typename T>
vec3<T> monotone_slope(const vec3<T>& slope, const vec3<T>& before, const vec3<T>& after) {
    const vec3<T> zero = vec3<T>(T(0), T(0), T(0));
    return glm::clamp(slope, T(3) * glm::min(zero, glm::max(before, after)),
                      T(3) * glm::max(zero, glm::min(before, after)));
}

/// A piece of a ray, by the depth of the source at its ends and at those beyond them.
///
/// The slopes at its ends are those of parabolas through three neighbours.
///
/// Units:    depths [1].
/// Shape:    the depths are spectra.
/// Domain:   source_depth at the ends i - 1, i, i + 1 and i + 2 of shaft_piece_end; before is not read for
///           i = 0, nor after for i = pieces - 1.
/// Accuracy: 12 roundoffs.
/// Errors:   none.
/// Source:   cubic Hermite interpolation; the slope of a parabola through three points.
template <typename T>
ShaftPiece<T> shaft_piece(const ShaftRay<T>& shaft, const vec3<T>& before, const vec3<T>& near_depth,
                          const vec3<T>& far_depth, const vec3<T>& after, int i, int pieces) {
    const T begin = shaft_piece_end(shaft, i, pieces);
    const T end = shaft_piece_end(shaft, i + 1, pieces);
    const T width = end - begin;
    const vec3<T> chord = (far_depth - near_depth) / width;
    vec3<T> chord_before = chord;
    vec3<T> chord_after = chord;
    vec3<T> near_slope = chord;
    vec3<T> far_slope = chord;
    if (i > 0) {
        const T width_before = begin - shaft_piece_end(shaft, i - 1, pieces);
        chord_before = (near_depth - before) / width_before;
        near_slope = chord_before + width_before / (width_before + width) * (chord - chord_before);
    }
    if (i + 1 < pieces) {
        const T width_after = shaft_piece_end(shaft, i + 2, pieces) - end;
        chord_after = (after - far_depth) / width_after;
        far_slope = chord + width / (width + width_after) * (chord_after - chord);
    }
    const vec3<T> met_near = near_slope;
    const vec3<T> met_far = far_slope;
    if (i == 0) {
        near_slope = T(2) * chord - met_far;
    }
    if (i + 1 >= pieces) {
        far_slope = T(2) * chord - met_near;
    }
    return ShaftPiece<T>{shaft.lit_length * begin,
                         shaft.lit_length * width,
                         near_depth,
                         far_depth,
                         width * monotone_slope(near_slope, chord_before, chord),
                         width * monotone_slope(far_slope, chord, chord_after)};
}

/// The source's share of the brightest, at a place of a piece.
///
/// Units:    x and result [1].
/// Shape:    the result is a spectrum.
/// Domain:   x from 0, the near end, to 1, the far end.
/// Accuracy: that of light_lost_in_shadow where all is dark; at the ends exact.
/// Errors:   none; within a rounding of the shares at the ends.
/// Source:   cubic Hermite interpolation.
template <typename T>
vec3<T> source_share(const ShaftPiece<T>& piece, T x) {
    const T y = T(1) - x;
    const vec3<T> chord = piece.far_depth - piece.near_depth;
    const vec3<T> bent = y * (piece.near_slope - chord) - x * (piece.far_slope - chord);
    return glm::exp(-(piece.near_depth + x * chord + (x * y) * bent));
}

/// The light that a stretch of a piece adds to the ray while the sun lights all of it: what is lost where a
/// stretch is known to be dark, as from a tree of least and greatest depths of a shadow map.
///
/// Two looks at the source, by Gauss's rule, however long the stretch is.
///
/// Units:    from and to [1]; result [1/sr] per unit of solar irradiance above the air.
/// Shape:    the result is a spectrum.
/// Domain:   0 <= from <= to <= 1, the piece's near end to its far end.
/// Accuracy: that of source_share; 0.5 % of a piece over which the source falls by e^2.
/// Errors:   none.
/// Source:   Gauss's rule with two points.
template <typename T>
vec3<T> light_between(const ShaftRay<T>& shaft, const ShaftPiece<T>& piece, T from, T to) {
    const T middle = T(0.5) * (from + to);
    const T reach = T(0.288675134594812882254574390250978728L) * (to - from);  // of its half, 1 / sqrt(3)
    const vec3<T> both = source_share(piece, middle - reach) + source_share(piece, middle + reach);
    return (T(0.5) * piece.extent * (to - from)) * (shaft.brightest * both);
}

/// The light that a ray loses to shadows in its air: shafts of light and of shadow, from few looks at the air
/// and many at the shadow.
///
///     lost = integral over the ray of (1 - V(x)) source(x) dx,     seen = single_scattering - lost
///
/// The source, sunlight scattered once towards the eye, is smooth and dear; the visibility V is rough and
/// cheap. So the source is taken at the ends of `pieces` only, its logarithm between them from a cubic, and V
/// at `looks` even places in each. `offset` shifts these: 0.5 for the middles, another at every pixel to
/// turn stripes into noise; the mean over all offsets is that of looks without number.
///
/// Beyond `range` from the eye, how far the shadow map reaches, nothing is lost. Nothing is lost twice
/// either: in the planet's own shadow there is no light to lose. Where all is lost, the difference may come
/// out below 0 by the errors of both: the caller takes its max with 0.
///
/// What is wrong is nearly all edges of shadow that fall between looks: where all is dark there are none, and
/// the mean of neighbours with other offsets has few left.
///
/// Units:    those of single_scattering; range [L]; offset [1]; result [1/sr] per unit of solar irradiance
///           above the air.
/// Shape:    the result is a spectrum.
/// Domain:   that of single_scattering; range >= 0, no_surface() for none; offset in [0, 1]; visibility in
///           [0, 1].
/// Accuracy: of the ray's whole light, in 95 % of the cases of its unit test: 8 x 8 looks 1.4 %, 16 x 50
///           looks 0.10 %, as a march of 800 steps has; all dark, 8 pieces 0.53 %, 16 pieces 0.054 %, and
///           0.21 % past the closest approach. Float as good as double.
/// Errors:   none; without air, or with pieces or looks below 1, 0. Never more than the ray can scatter.
/// Source:   docs/theory/nodes.md for the source; cubic Hermite interpolation of its logarithm.
template <typename T, typename Scene = DefaultScene, typename Visibility = AlwaysLit>
vec3<T> light_lost_in_shadow(const Atmosphere<T>& atmosphere, const Viewpoint<T>& eye,
                             const vec3<T>& direction, const vec3<T>& to_sun, T distance, T range, int pieces,
                             int looks, T offset, const Visibility& visibility = Visibility{}) {
    vec3<T> lost = vec3<T>(T(0), T(0), T(0));
    const AirRay<T> air = air_ray(atmosphere, eye, direction, glm::min(distance, range));
    if (!air.in_air || pieces < 1 || looks < 1) {
        return lost;
    }
    const LitRay<T> ray = lit_ray<T, Scene>(atmosphere, air, eye, direction, to_sun);
    const ShaftRay<T> shaft = shaft_ray<T, Scene>(atmosphere, ray);
    const T cell = T(1) / T(looks);  // of each look in its piece
    vec3<T> before = lost;
    vec3<T> here = source_depth<T, Scene>(atmosphere, ray, shaft, T(0));
    vec3<T> next =
        source_depth<T, Scene>(atmosphere, ray, shaft, shaft.lit_length * shaft_piece_end(shaft, 1, pieces));
    for (int i = 0; i < pieces; ++i) {
        vec3<T> after = next;
        if (i + 1 < pieces) {
            after = source_depth<T, Scene>(atmosphere, ray, shaft,
                                           shaft.lit_length * shaft_piece_end(shaft, i + 2, pieces));
        }
        const ShaftPiece<T> piece = shaft_piece(shaft, before, here, next, after, i, pieces);
        vec3<T> hidden = vec3<T>(T(0), T(0), T(0));
        for (int j = 0; j < looks; ++j) {
            const T lit = piece.begin + piece.extent * ((T(j) + offset) * cell);
            const T t = air.begin + shaft_distance(shaft, lit);
            const T dark = T(1) - visibility(direction * t);
            if (dark > T(0)) {
                hidden += dark * source_share(piece, (T(j) + T(0.5)) * cell);
            }
        }
        lost += (cell * piece.extent) * hidden;
        before = here;
        here = next;
        next = after;
    }
    return glm::min(shaft.brightest * lost, shaft.most);
}

}  // namespace airlight
