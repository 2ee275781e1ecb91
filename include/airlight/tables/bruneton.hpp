#pragma once

// CPU only. Bruneton and Neyret's table of scattered light: altitude, view, sun, and the angle between these.

#include <airlight/tables/scattering_orders.hpp>

namespace airlight {

/// Sizes of the table, those of Bruneton (2017) by default, and the lowest sun it knows.
template <typename T>
struct BrunetonShape {
    Atmosphere<T> atmosphere;
    int altitudes = 32;
    int views = 128;  ///< half of them for rays to the ground; an odd number counts as one more
    int suns = 32;
    int nus = 8;
    int irradiance_suns = 64;
    int irradiance_altitudes = 16;
    T lowest_sun = lowest_sun_cosine(atmosphere);

    int width() const {
        return nus * suns;
    }
    int height() const {
        return views + views % 2;
    }
    int depth() const {
        return altitudes;
    }
    int altitude_of(int, int k) const {
        return k;
    }
    int sun_of(int i, int) const {
        return i % suns;
    }
    /// What a texel stands for; its nu is one that the view and the sun can have.
    ScatteringPoint<T> point(int i, int j, int k) const {
        const vec3<T> centre((T(i) + T(0.5)) / T(width()), (T(j) + T(0.5)) / T(height()),
                             (T(k) + T(0.5)) / T(depth()));
        ScatteringPoint<T> p =
            scattering_parameters(atmosphere, centre, lowest_sun, nus, suns, height(), altitudes);
        p.nu = possible_nu(p.mu, p.mu_s, p.nu);
        return p;
    }
    /// Any texel of an altitude and a sun.
    ScatteringPoint<T> point_at(int altitude, int sun) const {
        return point(sun, 0, altitude);
    }
    vec3<T> read(const Table<vec3<T>>& table, T altitude, T mu, T mu_s, T nu, bool reaches_ground) const {
        const ScatteringLookup<T> at = scattering_lookup(atmosphere, altitude, mu, mu_s, nu, reaches_ground,
                                                         lowest_sun, nus, suns, height(), altitudes);
        return sample(table, at.first) * (T(1) - at.weight) + sample(table, at.second) * at.weight;
    }
};

}  // namespace airlight
