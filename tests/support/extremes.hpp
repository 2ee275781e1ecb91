#pragma once

// The whole documented domain, its ends included: worlds, eyes, rays and suns, drawn at random or from the
// bytes of a fuzzer (any source of numbers with the members of Draws).

#include <cmath>

#include <airlight/atmosphere.hpp>
#include <airlight/constants.hpp>
#include <airlight/types.hpp>
#include <airlight/viewpoint.hpp>

namespace airlight_test {

/// One end of a range, or anything between them, uniform in the logarithm; low > 0.
template <typename Draw>
double end_or_between(Draw& draw, double low, double high) {
    const int kind = draw.below(8);
    return kind == 0 ? low : kind == 1 ? high : draw.log_uniform(low, high);
}

/// The same or 0.
template <typename Draw>
double zero_or_between(Draw& draw, double low, double high) {
    return draw.below(8) == 0 ? 0.0 : end_or_between(draw, low, high);
}

/// A number of [-1, 1]: an end, the middle, close to one of them, or anywhere.
template <typename T, typename Draw>
T cosine(Draw& draw) {
    const T sign = T(draw.below(2) * 2 - 1);
    switch (draw.below(6)) {
        case 0:
            return sign;
        case 1:
            return T(0);
        case 2:
            return sign * T(draw.log_uniform(1e-30, 1.0));
        case 3:
            return sign * (T(1) - T(draw.log_uniform(1e-18, 1.0)));
        default:
            return T(draw.uniform(-1.0, 1.0));
    }
}

/// A parameter of (-1, 1), up to 1 - 1e-7.
template <typename T, typename Draw>
T lobe_parameter(Draw& draw) {
    const T sign = T(draw.below(2) * 2 - 1);
    return draw.below(4) == 0 ? sign * (T(1) - T(end_or_between(draw, 1e-7, 1.0)))
                              : T(draw.uniform(-0.9999999, 0.9999999));
}

/// 0 to 1e3 per scale height; for a layer without thickness per unit of length.
template <typename T, typename Draw>
airlight::vec3<T> coefficient(Draw& draw, T scale_height) {
    const T per = scale_height > T(0) ? scale_height : T(1);
    airlight::vec3<T> drawn;
    for (int i = 0; i < 3; ++i) {
        drawn[i] = T(zero_or_between(draw, 1e-6, 1e3)) / per;
    }
    return drawn;
}

/// Air of any kind around any ground sphere: layers without thickness and no air at all among them.
template <typename T, typename Draw>
airlight::Atmosphere<T> any_atmosphere(Draw& draw) {
    airlight::Atmosphere<T> air;
    air.ground_radius = T(end_or_between(draw, 100.0, 7e7));
    air.rayleigh_scale_height = T(zero_or_between(draw, 0.1, 1e6));
    air.top_altitude = draw.below(2) == 0 ? T(zero_or_between(draw, 1e-3, 1e12))
                                          : air.rayleigh_scale_height * T(draw.uniform(0.0, 20.0));
    air.rayleigh_scattering = coefficient(draw, air.rayleigh_scale_height);
    air.mie_scale_height = T(zero_or_between(draw, 0.1, 1e6));
    air.mie_scattering = coefficient(draw, air.mie_scale_height);
    air.mie_absorption = coefficient(draw, air.mie_scale_height);
    air.mie_g = lobe_parameter<T>(draw);
    air.ozone_altitude = T(zero_or_between(draw, 0.1, 1e6));
    air.ozone_half_width = T(zero_or_between(draw, 0.1, 1e6));
    air.ozone_absorption = coefficient(draw, air.ozone_half_width);
    air.ground_albedo = airlight::vec3<T>(T(draw.unit()));
    // Parameters that are equal: the layer's lower edge at the planet's centre, its parts at the top of the
    // air.
    switch (draw.below(16)) {
        case 0:
            air.ozone_half_width = air.ground_radius + air.ozone_altitude;
            break;
        case 1:
            air.ozone_altitude = air.top_altitude;
            break;
        case 2:
            air.ozone_half_width = air.ozone_altitude;
            break;
        case 3:
            air.ozone_half_width = std::fmax(air.top_altitude - air.ozone_altitude, T(0));
            break;
        case 4:
            air.mie_scale_height = air.rayleigh_scale_height;
            break;
        default:
            break;
    }
    return air;
}

/// From the planet's centre to 1e12 m, the ground and the top of the air among them.
template <typename T, typename Draw>
airlight::Viewpoint<T> any_viewpoint(Draw& draw, const airlight::Atmosphere<T>& air) {
    const airlight::vec3<T> up =
        draw.below(4) == 0 ? airlight::vec3<T>(T(0), T(0), T(1)) : draw.template direction<T>();
    switch (draw.below(9)) {
        case 0:
            return airlight::Viewpoint<T>{T(0), up};
        case 1:
            return airlight::Viewpoint<T>{-air.ground_radius * T(draw.unit()), up};
        case 2:
            return airlight::Viewpoint<T>{-air.ground_radius, up};
        case 3:
            return airlight::Viewpoint<T>{air.top_altitude, up};
        case 4:
            return airlight::Viewpoint<T>{air.top_altitude * T(draw.uniform(0.0, 1.5)), up};
        case 5:
            return airlight::Viewpoint<T>{air.rayleigh_scale_height * T(draw.uniform(0.0, 5.0)), up};
        case 6: {
            const T edge = air.ozone_altitude + T(draw.below(3) - 1) * air.ozone_half_width;
            return airlight::Viewpoint<T>{std::fmax(edge, -air.ground_radius), up};
        }
        default:
            return airlight::Viewpoint<T>{T(end_or_between(draw, 1e-6, 1e12)), up};
    }
}

/// From the planet's centre to a few radii above it, where a cosine still has the digits of a ray.
template <typename T, typename Draw>
T any_altitude(Draw& draw, const airlight::Atmosphere<T>& air) {
    const airlight::Viewpoint<T> eye = any_viewpoint(draw, air);
    const T height = draw.below(2) == 0 ? air.rayleigh_scale_height : air.mie_scale_height;
    return draw.below(2) == 0 ? height * T(draw.uniform(0.0, 10.0))
                              : std::fmin(eye.altitude, T(4) * (air.ground_radius + air.top_altitude));
}

/// Any direction; straight up, down and level; tangent to the ground, to the top of the air, and nearly so.
template <typename T, typename Draw>
airlight::vec3<T> any_direction(Draw& draw, const airlight::Atmosphere<T>& air,
                                const airlight::Viewpoint<T>& eye) {
    const int kind = draw.below(8);
    if (kind < 2) {
        return kind == 0 ? eye.up : -eye.up;
    }
    const airlight::vec3<T> drawn = draw.template direction<T>();
    airlight::vec3<T> side = glm::cross(eye.up, drawn);
    const T length = std::sqrt(glm::dot(side, side));
    if (kind > 5 || !(length > T(1e-3L))) {
        return drawn;
    }
    side /= length;
    if (kind == 2) {
        return side;
    }
    T radius = kind == 3 ? air.ground_radius : air.ground_radius + air.top_altitude;
    if (kind == 5) {
        radius = air.ground_radius + air.rayleigh_scale_height * T(draw.uniform(-1.0, 5.0));
    }
    const T from_centre = std::fmax(air.ground_radius + eye.altitude, radius);
    const T sine = std::fmax(radius / from_centre, T(0));
    return side * sine - eye.up * std::sqrt(std::fmax((T(1) - sine) * (T(1) + sine), T(0)));
}

/// Any sun: where the eye looks, behind its back, in the zenith and the nadir, on the horizon, anywhere.
template <typename T, typename Draw>
airlight::vec3<T> any_sun(Draw& draw, const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                          const airlight::vec3<T>& direction) {
    switch (draw.below(6)) {
        case 0:
            return direction;
        case 1:
            return -direction;
        case 2:
            return draw.below(2) == 0 ? eye.up : -eye.up;
        case 3:
            return any_direction(draw, air, eye);
        default:
            return draw.template direction<T>();
    }
}

/// 0, 1e-6, infinite, and what lies between.
template <typename T, typename Draw>
T any_distance(Draw& draw) {
    return draw.below(4) == 0 ? airlight::no_surface<T>() : T(zero_or_between(draw, 1e-6, 1e13));
}

}  // namespace airlight_test
