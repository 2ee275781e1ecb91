#pragma once

// From angles in degrees to directions over level ground.

#include <cmath>

#include <airlight/viewpoint.hpp>

namespace airlight_test {

using airlight::vec3;
using airlight::Viewpoint;

template <typename T>
vec3<T> slope(double elevation_degrees, double azimuth_degrees = 0.0) {
    const double e = elevation_degrees * 0.017453292519943295;
    const double a = azimuth_degrees * 0.017453292519943295;
    return vec3<T>(T(std::cos(e) * std::cos(a)), T(std::cos(e) * std::sin(a)), T(std::sin(e)));
}

template <typename T>
Viewpoint<T> standing(T altitude) {
    return Viewpoint<T>{altitude, vec3<T>(T(0), T(0), T(1))};
}

}  // namespace airlight_test
