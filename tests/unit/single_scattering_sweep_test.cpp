// The whole documented domain, at random and at its corners: no NaN, no infinity, radiance >= 0,
// transmittance in [0, 1].

#include <cmath>
#include <cstdio>
#include <string>

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

struct LorentzianHenyeyGreenstein : Lorentzian {
    static constexpr int mie_phase = phase_henyey_greenstein;
};
struct Bare : DefaultScene {
    static constexpr bool mie = false;
    static constexpr int ozone = ozone_none;
    static constexpr bool planet_shadow = false;
};

template <typename T>
T pick_height(Random& random) {
    return random.below(8) == 0 ? T(0) : T(random.log_uniform(0.1, 1e6));
}

// 0 to 1e3 per scale height; for a layer without thickness per unit of length.
template <typename T>
vec3<T> pick_coefficient(Random& random, T scale_height) {
    const T per = scale_height > T(0) ? scale_height : T(1);
    vec3<T> coefficient;
    for (int i = 0; i < 3; ++i) {
        coefficient[i] = random.below(4) == 0 ? T(0) : T(random.log_uniform(1e-6, 1e3)) / per;
    }
    return coefficient;
}

template <typename T>
Atmosphere<T> pick_atmosphere(Random& random) {
    Atmosphere<T> air;
    air.ground_radius = T(random.log_uniform(100.0, 7e7));
    air.top_altitude = T(random.log_uniform(1.0, 1e6));
    air.rayleigh_scale_height = pick_height<T>(random);
    air.rayleigh_scattering = pick_coefficient<T>(random, air.rayleigh_scale_height);
    air.mie_scale_height = pick_height<T>(random);
    air.mie_scattering = pick_coefficient<T>(random, air.mie_scale_height);
    air.mie_absorption = pick_coefficient<T>(random, air.mie_scale_height);
    air.mie_g = T(random.below(8) == 0 ? 0.999 * (random.below(2) * 2 - 1) : random.uniform(-0.999, 0.999));
    air.ozone_altitude = T(random.uniform(0.0, 1e5));
    air.ozone_half_width = pick_height<T>(random);
    air.ozone_absorption = pick_coefficient<T>(random, air.ozone_half_width);
    air.ground_albedo = vec3<T>(T(0.1L));
    return air;
}

// From the planet's centre to 1e12 m away, the ground and the top of the air among them.
template <typename T>
Viewpoint<T> pick_eye(Random& random, const Atmosphere<T>& air) {
    const vec3<T> up = random.below(4) == 0 ? vec3<T>(T(0), T(0), T(1)) : random.direction<T>();
    switch (random.below(7)) {
        case 0:
            return Viewpoint<T>{T(0), up};
        case 1:
            return Viewpoint<T>{-air.ground_radius * T(random.unit()), up};
        case 2:
            return Viewpoint<T>{-air.ground_radius, up};
        case 3:
            return Viewpoint<T>{air.top_altitude, up};
        case 4:
            return Viewpoint<T>{T(random.log_uniform(1e-3, 1e12)), up};
        default:
            return Viewpoint<T>{air.top_altitude * T(random.uniform(0, 1.5)), up};
    }
}

// Any direction; straight up, down, level; tangent to the ground or to the top of the air.
template <typename T>
vec3<T> pick_direction(Random& random, const Atmosphere<T>& air, const Viewpoint<T>& eye) {
    const int kind = random.below(8);
    if (kind == 0) {
        return eye.up;
    }
    if (kind == 1) {
        return -eye.up;
    }
    vec3<T> side = glm::cross(eye.up, random.direction<T>());
    const T length = std::sqrt(glm::dot(side, side));
    if (kind > 4 || !(length > T(1e-3L))) {
        return random.direction<T>();
    }
    side /= length;
    if (kind == 2) {
        return side;
    }
    const T radius = kind == 3 ? air.ground_radius : air.ground_radius + air.top_altitude;
    const T from_centre = glm::max(air.ground_radius + eye.altitude, radius);
    const T sine = radius / from_centre;
    return side * sine - eye.up * std::sqrt(glm::max((T(1) - sine) * (T(1) + sine), T(0)));
}

template <typename T>
vec3<T> pick_sun(Random& random, const Atmosphere<T>& air, const Viewpoint<T>& eye,
                 const vec3<T>& direction) {
    switch (random.below(6)) {
        case 0:
            return direction;  // into the sun
        case 1:
            return -direction;  // with the sun in the back
        case 2:
            return eye.up;
        case 3:
            return pick_direction(random, air, eye);
        default:
            return random.direction<T>();
    }
}

template <typename T>
T pick_distance(Random& random) {
    switch (random.below(5)) {
        case 0:
            return T(0);
        case 1:
            return T(1e-6L);
        case 2:
            return T(random.log_uniform(1e-3, 1e13));
        default:
            return no_surface<T>();
    }
}

std::string text(const char* name, long double value) {
    return std::string("\n    ") + name + " = " + exact(value);
}

template <typename T>
std::string text(const char* name, const vec3<T>& v) {
    return text((std::string(name) + ".x").c_str(), static_cast<long double>(v.x)) +
           text((std::string(name) + ".y").c_str(), static_cast<long double>(v.y)) +
           text((std::string(name) + ".z").c_str(), static_cast<long double>(v.z));
}

template <typename T>
std::string story(const char* function, const Atmosphere<T>& air, const Viewpoint<T>& eye,
                  const vec3<T>& direction, const vec3<T>& to_sun, T distance, int steps,
                  const vec3<T>& got) {
    return std::string(function) + "<" + type_name<T>() + ">" + text("ground_radius", air.ground_radius) +
           text("top_altitude", air.top_altitude) + text("rayleigh_scattering", air.rayleigh_scattering) +
           text("rayleigh_scale_height", air.rayleigh_scale_height) +
           text("mie_scattering", air.mie_scattering) + text("mie_absorption", air.mie_absorption) +
           text("mie_scale_height", air.mie_scale_height) + text("mie_g", air.mie_g) +
           text("ozone_absorption", air.ozone_absorption) + text("ozone_altitude", air.ozone_altitude) +
           text("ozone_half_width", air.ozone_half_width) + text("eye.altitude", eye.altitude) +
           text("eye.up", eye.up) + text("direction", direction) + text("to_sun", to_sun) +
           text("distance", distance) + text("steps", static_cast<long double>(steps)) + text("got", got);
}

template <typename T>
bool is_light(const vec3<T>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && v.x >= T(0) && v.y >= T(0) &&
           v.z >= T(0);
}

template <typename T>
bool is_share(const vec3<T>& v) {
    return is_light(v) && v.x <= T(1) && v.y <= T(1) && v.z <= T(1);
}

template <typename T, typename Scene>
void check_view(const Atmosphere<T>& air, const Viewpoint<T>& eye, const vec3<T>& direction,
                const vec3<T>& to_sun, T distance, int steps) {
    const Scattered<T> seen =
        single_scattering_marched<T, Scene>(air, eye, direction, to_sun, distance, steps);
    CHECK_MESSAGE(is_light(seen.radiance), story("single_scattering_marched.radiance", air, eye, direction,
                                                 to_sun, distance, steps, seen.radiance));
    CHECK_MESSAGE(is_share(seen.transmittance),
                  story("single_scattering_marched.transmittance", air, eye, direction, to_sun, distance,
                        steps, seen.transmittance));
}

}  // namespace

TEST_SUITE_BEGIN("single_scattering_sweep");

TEST_CASE_TEMPLATE("no view of any planet, from its centre to 1e12 m, gives NaN, infinity or negative light",
                   T, float, double, long double) {
    Random random(151);
    const int count = 60000;
    int in_air = 0;
    for (int i = 0; i < count; ++i) {
        const Atmosphere<T> air = pick_atmosphere<T>(random);
        const Viewpoint<T> eye = pick_eye(random, air);
        const vec3<T> direction = pick_direction(random, air, eye);
        const vec3<T> to_sun = pick_sun(random, air, eye, direction);
        const T distance = pick_distance<T>(random);
        const int steps = 1 + random.below(6);
        check_view<T, DefaultScene>(air, eye, direction, to_sun, distance, steps);
        check_view<T, LorentzianHenyeyGreenstein>(air, eye, direction, to_sun, distance, steps);
        check_view<T, Bare>(air, eye, direction, to_sun, distance, steps);

        const ViewPath<T> path = view_path(air, eye, direction, distance);
        CHECK_MESSAGE((std::isfinite(path.begin) && std::isfinite(path.end) && path.begin >= T(0) &&
                       path.end >= path.begin),
                      story("view_path", air, eye, direction, to_sun, distance, steps,
                            vec3<T>(path.begin, path.end, T(0))));
        in_air += path.in_air ? 1 : 0;
    }
    std::printf("sweep<%s>: %d views, %d of them through air\n", type_name<T>(), count, in_air);
    CHECK(in_air > count / 4);
}

TEST_CASE_TEMPLATE("no ray from the centre to a few radii gives a transmittance that is none", T, float,
                   double, long double) {
    Random random(152);
    for (int i = 0; i < 60000; ++i) {
        const Atmosphere<T> air = pick_atmosphere<T>(random);
        const T altitude = random.below(4) == 0 ? -air.ground_radius * T(random.unit())
                                                : T(random.log_uniform(1e-3, 3.0)) * air.ground_radius;
        const T mu = random.below(5) == 0 ? T(random.below(3) - 1) : T(random.uniform(-1, 1));
        const T distance = pick_distance<T>(random);
        const vec3<T> direction = vec3<T>(std::sqrt((T(1) - mu) * (T(1) + mu)), T(0), mu);
        const Viewpoint<T> eye = Viewpoint<T>{altitude, vec3<T>(T(0), T(0), T(1))};
        const vec3<T> along = transmittance<T, DefaultScene>(air, altitude, mu, distance);
        const vec3<T> to_space = transmittance_to_space<T, LorentzianHenyeyGreenstein>(air, altitude, mu);
        CHECK_MESSAGE(is_share(along),
                      story("transmittance", air, eye, direction, direction, distance, 4, along));
        CHECK_MESSAGE(is_share(to_space),
                      story("transmittance_to_space", air, eye, direction, direction, distance, 4, to_space));
    }
}

TEST_CASE_TEMPLATE("the same view in mars, earth and thick air from every corner of the eye's domain", T,
                   float, double, long double) {
    Atmosphere<T> thick = earth<T>();
    thick.rayleigh_scattering *= T(1e4L);
    const T far = T(1e12L);
    for (const Atmosphere<T>& air : {earth<T>(), mars<T>(), leenman_earth<T>(), thick}) {
        for (const T altitude : {-air.ground_radius, T(-1), T(0), T(1e-6L), T(2), air.top_altitude,
                                 2 * air.top_altitude, T(1e9L), far}) {
            for (const vec3<T>& direction : {vec3<T>(T(0), T(0), T(1)), vec3<T>(T(0), T(0), T(-1)),
                                             vec3<T>(T(1), T(0), T(0)), vec3<T>(T(0.6L), T(0), T(-0.8L))}) {
                for (const vec3<T>& sun :
                     {vec3<T>(T(0), T(0), T(1)), vec3<T>(T(0), T(0), T(-1)), vec3<T>(T(1), T(0), T(0)),
                      vec3<T>(T(-1), T(0), T(0)), direction, -direction}) {
                    for (const T distance : {T(0), T(1e-6L), T(100), no_surface<T>()}) {
                        check_view<T, DefaultScene>(air, Viewpoint<T>{altitude, vec3<T>(T(0), T(0), T(1))},
                                                    direction, sun, distance, 8);
                    }
                }
            }
        }
    }
}

TEST_SUITE_END();
