#pragma once

// What the sun's disc promises, and whatever hides it.

#include "extremes.hpp"
#include "promises.hpp"

namespace airlight_test {

template <typename T>
Verdict occultation_promises(const airlight::Occultation<T>& between, T limb_exponent) {
    using namespace airlight;
    Verdict verdict;
    const T area = visible_share(between);
    const T light = visible_share_of_light(between, limb_exponent);
    verdict.holds("visible_share is a share", is_share(area));
    verdict.holds("visible_share_of_light is a share", is_share(light));
    verdict.holds("what is wholly seen, or not at all, is so with a dark rim too",
                  (area > T(0) && area < T(1)) || light == area);
    return verdict;
}

/// A sphere of any size anywhere, and any place on a planet.
template <typename T>
Verdict shadow_promises(const airlight::vec3<T>& centre, T radius, const airlight::Atmosphere<T>& air,
                        const airlight::Viewpoint<T>& place, const airlight::vec3<T>& to_sun, T sin_radius,
                        T limb_exponent) {
    using namespace airlight;
    Verdict verdict;
    verdict.holds("sunlight_past_sphere is a share",
                  is_share(sunlight_past_sphere(centre, radius, to_sun, sin_radius, limb_exponent)));
    verdict.holds("sunlight_past_ground is a share",
                  is_share(sunlight_past_ground(air.ground_radius, place, vec3<T>(T(0)), to_sun, sin_radius,
                                                limb_exponent)));
    return verdict;
}

template <typename T>
Verdict sun_promises(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                     const airlight::vec3<T>& direction, const airlight::vec3<T>& to_sun,
                     const airlight::SunDisc<T>& disc, T altitude, T mu_s) {
    using namespace airlight;
    Verdict verdict;
    const vec3<T> radiance = sun_radiance(disc, direction, to_sun);
    const T mean = disc_radiance(disc.sin_radius);
    verdict.holds("disc_radiance is an amount", is_amount(mean));
    verdict.holds("sun_radiance is an amount", is_amount(radiance));
    for (int i = 0; i < 3; ++i) {
        verdict.holds("sun_radiance is at most that of the middle of a sharp disc",
                      radiance[i] <= mean * (T(1) + T(0.5) * disc.limb_exponents[i]) * T(1.001L));
    }
    const Scattered<T> through = {vec3<T>(T(0)), vec3<T>(T(1))};
    verdict.holds("sky_with_sun is an amount",
                  is_amount(sky_with_sun(air, eye, direction, to_sun, disc, through)));
    verdict.holds("sunlight is a share", is_share(sunlight(air, altitude, mu_s, disc.sin_radius)));
    const T middle = visible_middle(mu_s * T(1.5L));
    verdict.holds("visible_middle is a share of the radius",
                  is_amount(middle) && middle <= T(1) + T(32) * std::numeric_limits<T>::epsilon());
    return verdict;
}

template <typename T, typename Draw>
void check_any_sun(Verdict& all, Draw& draw) {
    using namespace airlight;
    // Gaps at all the ends where one kind of overlap becomes another.
    const T curvature = draw.below(4) == 0 ? T(1) : T(zero_or_between(draw, 1e-12, 1e12));
    const T inside = curvature > T(1) ? T(1) - T(2) / curvature : T(-1);
    const T ends[] = {T(-1), T(0), T(1), inside, -inside};
    const T epsilon = std::numeric_limits<T>::epsilon();
    T gap = draw.below(2) == 0 ? ends[draw.below(5)] : T(draw.uniform(-1.5, 1.5));
    gap = draw.below(2) == 0 ? gap : gap * (T(1) + T(draw.below(9) - 4) * epsilon);
    const Occultation<T> between = {curvature * gap < T(-1) ? inside : gap, curvature};
    const T limb_exponent = T(zero_or_between(draw, 1e-3, 2.0));
    all.add(occultation_promises(between, limb_exponent), [&] {
        return told("gap", between.gap) + told("curvature", between.curvature) +
               told("limb_exponent", limb_exponent);
    });

    const Atmosphere<T> air = any_atmosphere<T>(draw);
    const Viewpoint<T> eye = any_viewpoint<T>(draw, air);
    const vec3<T> to_sun = any_direction<T>(draw, air, eye);
    const T sin_radius = T(end_or_between(draw, 1e-6, 1.0));
    const T radius = T(zero_or_between(draw, 1e-3, 1e12));
    const vec3<T> centre = draw.template direction<T>() * T(zero_or_between(draw, 1e-3, 1e12));
    all.add(shadow_promises(draw.below(4) == 0 ? to_sun * (T(2) * radius) : centre, radius, air, eye, to_sun,
                            draw.below(8) == 0 ? T(0) : sin_radius, limb_exponent),
            [&] {
                return told(air) + told("altitude", eye.altitude) + told("up", eye.up) +
                       told("to_sun", to_sun) + told("centre", centre) + told("radius", radius) +
                       told("sin_radius", sin_radius);
            });

    SunDisc<T> disc = solar_disc<T>();
    disc.sin_radius = sin_radius;
    disc.sin_edge = std::fmin(sin_radius * T(zero_or_between(draw, 1e-6, 1e3)), T(1));
    disc.limb_exponents.x = T(zero_or_between(draw, 1e-3, 2.0));
    // At the sun, on its rim, and anywhere.
    vec3<T> direction = to_sun;
    if (draw.below(4) != 0) {
        const vec3<T> off = draw.template direction<T>() * (sin_radius * T(zero_or_between(draw, 1e-3, 3.0)));
        direction = to_sun + off;
        const T length = std::sqrt(dot_product(direction, direction));
        direction = length > T(0.01L) ? direction / length : -to_sun;
    }
    const T altitude = any_altitude<T>(draw, air);
    const T mu_s = cosine<T>(draw);
    all.add(sun_promises(air, eye, direction, to_sun, disc, altitude, mu_s), [&] {
        return told(air) + told("altitude", eye.altitude) + told("up", eye.up) +
               told("direction", direction) + told("to_sun", to_sun) + told("sin_radius", disc.sin_radius) +
               told("sin_edge", disc.sin_edge) + told("limb exponents", disc.limb_exponents) +
               told("altitude of sunlight", altitude) + told("mu_s", mu_s);
    });
}

}  // namespace airlight_test
