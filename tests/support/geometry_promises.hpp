#pragma once

// What crossings, viewpoints and view paths promise.

#include "extremes.hpp"
#include "promises.hpp"

namespace airlight_test {

/// How far a point found on a sphere may lie off it: roundoffs of the lengths that it was found from
/// (measured: 3).
template <typename T>
T off_sphere(T lengths) {
    return T(16) * std::numeric_limits<T>::epsilon() * lengths;
}

/// Altitude of a point of a ray, by its closest approach to the centre: in long double, and from however far.
template <typename T>
long double altitude_by_perigee(T radius, T altitude, T mu, T distance) {
    using Real = long double;
    const Real from_centre = Real(radius) + Real(altitude);
    const Real perigee = from_centre * std::sqrt((Real(1) - Real(mu)) * (Real(1) + Real(mu)));
    const Real along = from_centre * Real(mu) + Real(distance);
    const Real w = (perigee - Real(radius)) * (perigee + Real(radius)) + along * along;
    return w / (Real(radius) + std::sqrt(Real(radius) * Real(radius) + w));
}

template <typename T>
Verdict ray_sphere_promises(T radius, T altitude, T mu) {
    using namespace airlight;
    Verdict verdict;
    const RaySphereHit<T> hit = intersect_ray_sphere(radius, altitude, mu);
    verdict.holds("t_near and t_far are finite", is_finite(hit.t_near) && is_finite(hit.t_far));
    verdict.holds("t_near <= t_far", hit.t_near <= hit.t_far);
    verdict.holds("a miss has both distances 0", hit.hit || (hit.t_near == T(0) && hit.t_far == T(0)));
    verdict.holds("a ray from inside hits", hit.hit || altitude > T(0));
    if (hit.hit) {
        const T bound = off_sphere(radius + std::fabs(altitude));
        verdict.within("t_near lies on the sphere",
                       T(std::fabs(altitude_by_perigee(radius, altitude, mu, hit.t_near))), bound);
        verdict.within("t_far lies on the sphere",
                       T(std::fabs(altitude_by_perigee(radius, altitude, mu, hit.t_far))), bound);
    }
    return verdict;
}

template <typename T>
void viewpoint_law(Verdict& verdict, const airlight::Viewpoint<T>& eye, T ground_radius, T lengths) {
    using namespace airlight;
    const T u = std::numeric_limits<T>::epsilon() / 2;
    verdict.holds("altitude is finite", is_finite(eye.altitude));
    verdict.within("altitude is not below the centre", -ground_radius - eye.altitude, T(8) * u * lengths);
    verdict.within("up is a unit vector", std::fabs(dot_product(eye.up, eye.up) - T(1)), T(16) * u);
}

/// A position from the centre, or from a point on the ground whose vertical is `up_at_origin`.
template <typename T>
Verdict viewpoint_promises(T ground_radius, const airlight::vec3<T>& position,
                           const airlight::vec3<T>& up_at_origin) {
    using namespace airlight;
    Verdict verdict;
    const T size = std::fabs(position.x) + std::fabs(position.y) + std::fabs(position.z);
    viewpoint_law(verdict, viewpoint_from_centre(ground_radius, position), ground_radius,
                  ground_radius + size);
    viewpoint_law(verdict, viewpoint_from_surface(ground_radius, position, up_at_origin), ground_radius,
                  ground_radius + size + size * (size / ground_radius));
    return verdict;
}

template <typename T>
Verdict view_path_promises(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                           const airlight::vec3<T>& direction, T distance) {
    using namespace airlight;
    Verdict verdict;
    const AirRay<T> ray = air_ray(air, eye, direction, distance);
    verdict.holds("ray.begin and ray.extent are amounts", is_amount(ray.begin) && is_amount(ray.extent));
    verdict.holds("ray.altitude is inside the air",
                  is_amount(ray.altitude) && ray.altitude <= air.top_altitude);
    verdict.holds("ray.along is finite", is_finite(ray.along));
    verdict.holds("a ray in the air has a length", ray.in_air == (ray.extent > T(0)));
    const ViewPath<T> path = view_path(air, eye, direction, distance);
    verdict.holds("begin and end are amounts", is_amount(path.begin) && is_amount(path.end));
    verdict.holds("begin <= end", path.begin <= path.end);
    verdict.holds("a path outside the air has no length",
                  path.in_air || (path.begin == T(0) && path.end == T(0)));
    // begin + (distance - begin) may round up.
    const T u = std::numeric_limits<T>::epsilon() / 2;
    verdict.holds("the path ends at the surface", path.end <= distance * (T(1) + T(2) * u));
    if (ray.in_air) {
        const T lengths = air.ground_radius + air.top_altitude + std::fabs(ray.along) + ray.extent;
        const T end_altitude = altitude_along_ray(air.ground_radius, ray.altitude, ray.along, ray.extent);
        // altitude_along_ray takes differences of squares over the radius.
        const T bound = off_sphere(lengths * std::fmax(lengths / air.ground_radius, T(1)));
        verdict.within("the end is not above the air", end_altitude - air.top_altitude, bound);
        verdict.within("the end is not below the ground", -end_altitude, bound);
        if (ray.reaches_ground) {
            verdict.within("a path to the ground ends on it", std::fabs(end_altitude), bound);
        }
    }
    return verdict;
}

/// Any ray against a sphere, any position around a planet, any view ray through its air.
template <typename T, typename Draw>
void check_any_geometry(Verdict& all, Draw& draw) {
    const airlight::Atmosphere<T> air = any_atmosphere<T>(draw);
    const airlight::Viewpoint<T> eye = any_viewpoint(draw, air);
    const T mu = cosine<T>(draw);
    all.add(ray_sphere_promises(air.ground_radius, eye.altitude, mu), [&] {
        return told("radius", air.ground_radius) + told("altitude", eye.altitude) + told("mu", mu);
    });

    // From the planet's centre itself to 1e12 m from it.
    const airlight::vec3<T> up = draw.template direction<T>();
    const airlight::vec3<T> position =
        draw.below(8) == 0 ? -air.ground_radius * up
                           : draw.template direction<T>() * T(zero_or_between(draw, 1e-12, 1e12));
    all.add(viewpoint_promises(air.ground_radius, position, up), [&] {
        return told("ground_radius", air.ground_radius) + told("position", position) + told("up", up);
    });

    const airlight::vec3<T> direction = any_direction(draw, air, eye);
    const T distance = any_distance<T>(draw);
    all.add(view_path_promises(air, eye, direction, distance), [&] {
        return told(air) + told("eye.altitude", eye.altitude) + told("eye.up", eye.up) +
               told("direction", direction) + told("distance", distance);
    });
}

}  // namespace airlight_test
