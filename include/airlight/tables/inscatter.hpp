#pragma once

// CPU only. A table of scattered light over altitude, view and sun. The azimuth between view and sun is
// dropped: the sun's height at a point far along the ray depends on it, so that the table is an approximation
// even of light scattered once.

#include <airlight/tables/scattering_orders.hpp>

namespace airlight {

/// Sizes of the table and the lowest sun it knows.
template <typename T>
struct InscatterShape {
    Atmosphere<T> atmosphere;
    int altitudes = 32;
    int views = 128;  ///< half of them for rays to the ground; an odd number counts as one more
    int suns = 64;
    int irradiance_suns = 64;
    int irradiance_altitudes = 16;
    T lowest_sun = lowest_sun_cosine(atmosphere);

    int width() const {
        return altitudes;
    }
    int height() const {
        return views + views % 2;
    }
    int depth() const {
        return suns;
    }
    int altitude_of(int i, int) const {
        return i;
    }
    int sun_of(int, int k) const {
        return k;
    }
    /// What a texel stands for: the sun at right angles to the view's azimuth, half way between the two that
    /// differ most.
    ScatteringPoint<T> point(int i, int j, int k) const {
        const vec3<T> centre((T(i) + T(0.5)) / T(width()), (T(j) + T(0.5)) / T(height()),
                             (T(k) + T(0.5)) / T(depth()));
        const AltitudeViewSun<T> p =
            inscatter_parameters(atmosphere, centre, lowest_sun, altitudes, height(), suns);
        return ScatteringPoint<T>{p.altitude, p.mu, p.mu_s, p.mu * p.mu_s, p.reaches_ground};
    }
    /// Any texel of an altitude and a sun.
    ScatteringPoint<T> point_at(int altitude, int sun) const {
        return point(altitude, 0, sun);
    }
    vec3<T> read(const Table<vec3<T>>& table, T altitude, T mu, T mu_s, T, bool reaches_ground) const {
        return sample(table, inscatter_uvw(atmosphere, altitude, mu, mu_s, reaches_ground, lowest_sun,
                                           altitudes, height(), suns));
    }
};

}  // namespace airlight
