#pragma once

// The rays of the study.

#include <string>
#include <vector>

#include "converted.hpp"
#include "worlds.hpp"

namespace study {

/// One ray in one world.
template <typename T>
struct Ray {
    airlight::Viewpoint<T> eye;
    airlight::vec3<T> direction;
    airlight::vec3<T> to_sun;
    T distance;  ///< of the surface it ends on, or airlight::no_surface
};

struct View {
    std::string kind;  ///< ground, high, space, surface, or random
    std::string name;  ///< what is seen from where, unique within its world
    std::size_t world;
    Ray<double> ray;
};

/// The suite: 125 views of each world. From 2 m and 200 m with the sun from the zenith to 6 degrees below
/// the horizon, from 10 km, the limb and the disc from 1000 km, and surfaces at 1 to 100 km.
std::vector<View> suite();

/// Rays drawn from a seed, the same with every standard library, spread evenly over the worlds.
std::vector<View> random_views(int count);

/// By what luminance errors are measured: the zenith's with the sun in it, seen from 2 m.
View noon_zenith(std::size_t world);

/// The same ray in another scalar type.
template <typename T>
Ray<T> converted(const Ray<double>& ray) {
    using airlight_test::converted;
    return Ray<T>{{T(ray.eye.altitude), converted<T>(ray.eye.up)},
                  converted<T>(ray.direction),
                  converted<T>(ray.to_sun),
                  T(ray.distance)};
}

}  // namespace study
