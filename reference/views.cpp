#include "views.hpp"

#include <airlight/constants.hpp>
#include <cmath>
#include <sstream>

namespace reference {
namespace {

double radians(double degrees) {
    return degrees * airlight::pi<double> / 180;
}

}  // namespace

Vector direction_at(double elevation, double azimuth) {
    const double e = radians(elevation);
    const double a = radians(azimuth);
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

std::string View::name() const {
    std::ostringstream out;
    out << altitude << " m; sun " << sun_elevation << "; view " << elevation << " / " << azimuth;
    return out.str();
}

Radiance traced(const Air& air, const View& view, double sun_diameter, const Effort& effort) {
    Light light;
    light.to_sun = direction_at(view.sun_elevation);
    light.sun_radius = radians(sun_diameter) / 2;
    const Vector eye(0, 0, air.ground_radius() + view.altitude);
    const ViewRay ray = view_ray(air, eye, direction_at(view.elevation, view.azimuth));
    return traced(air, light, ray, effort);
}

std::vector<View> judged_views() {
    std::vector<View> out;
    for (const double sun : {60.0, 20.0, 5.0, 0.0, -3.0, -6.0, -9.0, -12.0}) {
        out.push_back({2, sun, 90, 0});
        out.push_back({2, sun, 30, 90});
        out.push_back({2, sun, 2, 0});
        out.push_back({2, sun, 2, 180});
    }
    for (const double sun : {20.0, -3.0}) {
        out.push_back({10e3, sun, 90, 0});
        out.push_back({10e3, sun, 0, 90});
        out.push_back({10e3, sun, -10, 0});
    }
    // The horizon of an eye at 400 km lies 19.8 degrees down; 19 is a limb ray 33 km up, 19.6 one at 10 km.
    for (const double sun : {40.0, -15.0}) {
        out.push_back({400e3, sun, -90, 0});
        out.push_back({400e3, sun, -19.6, 0});
    }
    // Away from the sun's own azimuth and from right angles to it, where an interpolation has nothing to hold
    // on.
    for (const double sun : {60.0, 20.0, 5.0, 0.0, -3.0, -6.0}) {
        out.push_back({2, sun, 2, 30});
        out.push_back({2, sun, 2, 60});
        out.push_back({2, sun, 10, 45});
        out.push_back({2, sun, 15, 120});
    }
    return out;
}

}  // namespace reference
