#pragma once

// Views of the sky for tests of single scattering: eye, direction, sun, hooks that keep books, and when the
// light of two is the same.

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "angles.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

namespace airlight_test {

using airlight::Atmosphere;
using airlight::no_surface;
using airlight::Scattered;
using airlight::vec3;
using airlight::Viewpoint;

// Share of sunlight, the same everywhere.
struct Shaded {
    double share;
    template <typename T>
    T operator()(const vec3<T>&) const {
        return T(share);
    }
};

// Lit before `distance` from the eye, or behind it.
struct HalfLit {
    double distance;
    bool near;
    template <typename T>
    T operator()(const vec3<T>& position) const {
        return (glm::dot(position, position) < T(distance * distance)) == near ? T(1) : T(0);
    }
};

// Keeps the positions it is asked for.
template <typename T>
struct Recorder {
    std::vector<vec3<T>>* positions;
    T operator()(const vec3<T>& position) const {
        positions->push_back(position);
        return T(1);
    }
};

template <typename T>
struct View {
    Viewpoint<T> eye;
    vec3<T> direction;
    vec3<T> to_sun;
    T distance;
};

template <typename T>
View<T> random_view(Random& random) {
    View<T> view;
    view.eye = Viewpoint<T>{T(random.log_uniform(1, 1e6)), random.direction<T>()};
    view.direction = random.direction<T>();
    view.to_sun = random.direction<T>();
    view.distance = random.below(2) == 0 ? no_surface<T>() : T(random.log_uniform(10, 1e6));
    return view;
}

// The air of the reference table: coefficients that float holds exactly.
template <typename T>
Atmosphere<T> table_air() {
    Atmosphere<T> planet = airlight::earth<T>();
    planet.rayleigh_scattering = vec3<T>(vec3<float>(5.802e-6f, 13.558e-6f, 33.1e-6f));
    planet.mie_scattering = vec3<T>(vec3<float>(3.996e-6f));
    planet.mie_absorption = vec3<T>(vec3<float>(0.444e-6f));
    planet.ozone_absorption = vec3<T>(vec3<float>(0.65e-6f, 1.881e-6f, 0.085e-6f));
    planet.mie_g = T(0.8f);
    return planet;
}

template <typename T>
View<T> table_view(const Row& row) {
    const vec3<T> direction = vec3<T>(row.input<T>("dx"), row.input<T>("dy"), row.input<T>("dz"));
    const vec3<T> to_sun = vec3<T>(row.input<T>("sx"), row.input<T>("sy"), row.input<T>("sz"));
    return View<T>{standing(row.input<T>("altitude")), direction / std::sqrt(glm::dot(direction, direction)),
                   to_sun / std::sqrt(glm::dot(to_sun, to_sun)),
                   row.text("distance") == "none" ? no_surface<T>() : row.input<T>("distance")};
}

/// The same light to the bit; the test case says by which method.
template <typename T>
void check_same(const Scattered<T>& a, const Scattered<T>& b) {
    for (int i = 0; i < 3; ++i) {
        CHECK_EQUAL(compare_ulp("radiance", {{"channel", T(i)}}, a.radiance[i], b.radiance[i]));
        CHECK_EQUAL(
            compare_ulp("transmittance", {{"channel", T(i)}}, a.transmittance[i], b.transmittance[i]));
    }
}

}  // namespace airlight_test
