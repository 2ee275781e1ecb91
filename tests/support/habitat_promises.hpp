#pragma once

// What the air and the lights of a habitat promise, whatever the habitat.

#include "extremes.hpp"
#include "promises.hpp"

namespace airlight_test {

/// From a jar to a moon, without spin or with a density that rises by exp(60) to the wall, empty or opaque.
template <typename T, typename Draw>
airlight::HabitatAir<T> any_habitat(Draw& draw) {
    const double radius = draw.log_uniform(1e-2, 1e6);
    const double rise = zero_or_between(draw, 1e-8, 60.0) / (radius * radius);
    airlight::HabitatAir<T> air{};
    air.radius = T(radius);
    air.density_rise = T(rise);
    for (int i = 0; i < 3; ++i) {
        air.rayleigh_scattering[i] = T(zero_or_between(draw, 1e-6, 1e3) / radius);
        air.mie_scattering[i] = T(zero_or_between(draw, 1e-6, 1e3) / radius);
        air.mie_absorption[i] = T(zero_or_between(draw, 1e-6, 1e3) / radius);
    }
    air.mie_g = T(draw.uniform(-0.95, 0.95));
    return air;
}

/// Within the wall, on it or on the axis.
template <typename T, typename Draw>
airlight::vec3<T> any_place(Draw& draw, const airlight::HabitatAir<T>& air) {
    const airlight::vec3<T> side = draw.template direction<T>();
    const T along = air.radius * T(zero_or_between(draw, 1e-3, 1e3)) * (draw.below(2) == 0 ? T(1) : T(-1));
    const T away = air.radius * (draw.below(4) == 0 ? T(draw.below(2)) : T(draw.unit()));
    return airlight::vec3<T>(along, away * side.y, away * side.z);
}

/// Anywhere in it, in any position, without length or width too.
template <typename T, typename Draw>
airlight::LinearLight<T> any_strip(Draw& draw, const airlight::HabitatAir<T>& air) {
    const airlight::vec3<T> along =
        draw.below(2) == 0 ? airlight::vec3<T>(T(1), T(0), T(0)) : draw.template direction<T>();
    const airlight::vec3<T> other = glm::abs(along.y) < T(0.8) ? airlight::vec3<T>(T(0), T(1), T(0))
                                                               : airlight::vec3<T>(T(0), T(0), T(1));
    const airlight::vec3<T> normal = glm::normalize(glm::cross(along, other));
    const T half_length = air.radius * T(zero_or_between(draw, 1e-6, 10.0));
    const T width = air.radius * T(zero_or_between(draw, 1e-9, 1.0));
    const airlight::vec3<T> centre = any_place(draw, air);
    return {centre,      along, normal,
            half_length, width, airlight::vec3<T>(T(zero_or_between(draw, 1e-6, 1e6)))};
}

template <typename T>
Verdict habitat_promises(const airlight::HabitatAir<T>& air, const airlight::LinearLight<T>& light,
                         const airlight::vec3<T>& eye, const airlight::vec3<T>& end,
                         const airlight::vec3<T>& normal) {
    using namespace airlight;
    Verdict verdict;
    const vec3<T> way = end - eye;
    const T distance = glm::sqrt(dot_product(way, way));
    const vec3<T> direction = distance > T(0) ? way / distance : vec3<T>(T(1), T(0), T(0));
    const T column = habitat_column(air, eye, end);
    verdict.holds("habitat_column is an amount", is_amount(column));
    // The wall's density is 1; rounding may put a place outside by a roundoff of 60.
    verdict.holds("habitat_column is at most the way", column <= distance * T(1.0001L));
    verdict.holds("habitat_transmittance is a share", is_share(habitat_transmittance(air, eye, end)));
    const CylinderHit<T> hit = intersect_capped_cylinder(air.radius, air.radius, eye, direction);
    verdict.holds("a ray's ends are no NaN and in order", hit.t_near <= hit.t_far);

    const StripView<T> view = strip_view(light, eye);
    verdict.holds("a strip's solid angle is an amount", is_amount(view.solid_angle));
    verdict.holds("and at most half of all directions", view.solid_angle <= T(6.2832L));
    for (const T share : {T(0.001L), T(0.5L), T(0.999L)}) {
        const vec3<T> point = strip_point(view, share);
        verdict.holds("a strip's point is finite",
                      is_finite(point.x) && is_finite(point.y) && is_finite(point.z));
    }
    const vec3<T> lit = strip_irradiance(light, eye, normal);
    verdict.holds("strip_irradiance is an amount", is_amount(lit));
    verdict.holds("and at most pi times the radiance", lit.x <= T(3.1416L) * light.radiance.x);
    const vec3<T> mean = strip_mean_radiance(air, light, eye, 1);
    verdict.holds("strip_mean_radiance is an amount", is_amount(mean));
    verdict.holds("and at most half of the radiance", mean.x <= T(0.50001L) * light.radiance.x);
    verdict.holds("strip_source is an amount", is_amount(strip_source(air, light, eye, direction, 1)));
    verdict.holds("strip_scattering is an amount",
                  is_amount(strip_scattering(air, light, eye, direction, distance, 1)));

    const PointLight<T> lamp{light.centre, light.radiance, light.normal, T(0.9L), T(0.5L)};
    const vec3<T> of_lamp = point_scattering(air, lamp, eye, direction, distance);
    verdict.holds("point_scattering is an amount", is_amount(of_lamp));
    const HabitatLights<T> six{T(3) * air.radius, air.radius,     T(2) * air.radius,
                               light.width,       light.radiance, T(0.02L) * air.radius,
                               T(0.08L)};
    verdict.holds("habitat_scattering_by_nodes is an amount",
                  is_amount(habitat_scattering_by_nodes(air, six, eye, direction, distance)));
    verdict.holds("habitat_scattering_marched is an amount",
                  is_amount(habitat_scattering_marched(air, six, eye, direction, distance, 4)));
    verdict.holds("habitat_mean_passed is an amount", is_amount(habitat_mean_passed(air, six, eye, 1)));
    verdict.holds("unit_from_habitat is a share", is_share(unit_from_habitat(air, six, eye)));

    const StripPart<T> part = strip_part_above(view, normal);
    verdict.holds("the part of a strip above a plane is on it",
                  part.begin >= view.begin && part.begin <= part.end && part.end <= view.end);
    const vec3<T> in_air = strip_irradiance_in_air(air, light, eye, normal, 1);
    verdict.holds("strip_irradiance_in_air is an amount", is_amount(in_air));
    verdict.holds("and no more than without air", in_air.x <= T(1.00001L) * lit.x);
    verdict.holds("habitat_irradiance is an amount", is_amount(habitat_irradiance(air, six, eye, normal, 1)));
    const HabitatWall<T> wall = habitat_wall(air, six, eye, direction);
    verdict.holds("habitat_wall is a place", is_amount(wall.distance) && is_finite(wall.position.x) &&
                                                 is_finite(wall.position.y) && is_finite(wall.position.z));
    verdict.holds("a wall's normal has length 1",
                  glm::abs(dot_product(wall.normal, wall.normal) - T(1)) <= T(1e-5L));
    const vec3<T> albedo = vec3<T>(glm::abs(normal.x), T(1), T(0));
    verdict.holds("habitat_wall_radiance is an amount",
                  is_amount(habitat_wall_radiance(air, six, albedo, wall.position, wall.normal)));
    verdict.holds("habitat_radiance is an amount",
                  is_amount(habitat_radiance(air, six, albedo, eye, direction)));
    const HabitatIndirect<T> gathered = gathered_habitat_light(air, six, albedo, eye, 3);
    verdict.holds("gathered_habitat_light is an amount",
                  is_amount(gathered.mean) && is_amount(gathered.irradiance));
    return verdict;
}

template <typename T, typename Draw>
void check_any_habitat(Verdict& all, Draw& draw) {
    using namespace airlight;
    const HabitatAir<T> air = any_habitat<T>(draw);
    const LinearLight<T> light = any_strip<T>(draw, air);
    const vec3<T> eye = draw.below(8) == 0 ? light.centre : any_place<T>(draw, air);
    const vec3<T> end = draw.below(8) == 0 ? eye : any_place<T>(draw, air);
    const vec3<T> normal = draw.template direction<T>();
    all.add(habitat_promises(air, light, eye, end, normal), [&] {
        return told("radius", air.radius) + told("density_rise", air.density_rise) +
               told("rayleigh_scattering", air.rayleigh_scattering) +
               told("mie_scattering", air.mie_scattering) + told("mie_absorption", air.mie_absorption) +
               told("mie_g", air.mie_g) + told("centre", light.centre) + told("along", light.along) +
               told("light's normal", light.normal) + told("half_length", light.half_length) +
               told("width", light.width) + told("radiance", light.radiance) + told("eye", eye) +
               told("end", end) + told("normal", normal);
    });
}

}  // namespace airlight_test
