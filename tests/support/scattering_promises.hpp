#pragma once

// What single scattering promises for one view. An integrator is a functor
//     Scattered<T> operator()<T, Scene>(air, eye, direction, to_sun, distance, visibility).

#include "column_promises.hpp"
#include "extremes.hpp"
#include "promises.hpp"
#include "scenes.hpp"

namespace airlight_test {

/// single_scattering_marched as an integrator.
struct Marched {
    int steps;

    template <typename T, typename Scene, typename Visibility>
    airlight::Scattered<T> view(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                                const airlight::vec3<T>& direction, const airlight::vec3<T>& to_sun,
                                T distance, const Visibility& visibility) const {
        return airlight::single_scattering_marched<T, Scene, Visibility>(air, eye, direction, to_sun,
                                                                         distance, steps, visibility);
    }
    /// By which share of what the air takes from a ray its light may exceed it: none, for a step scatters tau
    /// exp(-tau / 2) of what comes, less than the 1 - exp(-tau) that it takes.
    static constexpr long double energy_excess = 0;
    /// Whether transmittances are those of columns; the march's are sums over its steps.
    static constexpr bool has_columns = false;
};

/// single_scattering with so many nodes as an integrator.
template <int Nodes>
struct ByNodes {
    template <typename Scene>
    struct WithNodes : Scene {
        static constexpr int nodes = Nodes;
    };

    template <typename T, typename Scene, typename Visibility>
    airlight::Scattered<T> view(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                                const airlight::vec3<T>& direction, const airlight::vec3<T>& to_sun,
                                T distance, const Visibility& visibility) const {
        return airlight::single_scattering<T, WithNodes<Scene>, Visibility>(air, eye, direction, to_sun,
                                                                            distance, visibility);
    }
    /// Docstring of most_scattered.
    static constexpr long double energy_excess = 0.03L;
    static constexpr bool has_columns = true;
};

/// What is dark where another hook lets light through.
template <typename Visibility>
struct Opposite {
    Visibility visibility;

    template <typename T>
    T operator()(const airlight::vec3<T>& position) const {
        return T(1) - visibility(position);
    }
};

/// light_lost_in_shadow as an integrator: a shadow that leaves dark what is lit takes the light of a ray.
struct ByShafts {
    int pieces;
    int looks;

    template <typename T, typename Scene, typename Visibility>
    airlight::Scattered<T> view(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                                const airlight::vec3<T>& direction, const airlight::vec3<T>& to_sun,
                                T distance, const Visibility& visibility) const {
        using namespace airlight;
        const vec3<T> lost =
            light_lost_in_shadow<T, Scene>(air, eye, direction, to_sun, distance, no_surface<T>(), pieces,
                                           looks, T(0.5), Opposite<Visibility>{visibility});
        const AirRay<T> ray = air_ray(air, eye, direction, distance);
        if (!ray.in_air) {
            return Scattered<T>{lost, vec3<T>(T(1), T(1), T(1))};
        }
        const LitRay<T> lit = lit_ray<T, Scene>(air, ray, eye, direction, to_sun);
        return Scattered<T>{lost,
                            glm::exp(-depth_of_any_legs<T, Scene>(air, lit, ray_legs<T, Scene>(air, lit)))};
    }
    /// Docstring of most_scattered.
    static constexpr long double energy_excess = 0.03L;
    /// A transmittance is none of its results, only what the most of its light follows from.
    static constexpr bool has_columns = false;
};

/// Hook: no sunlight reaches any sample.
struct Eclipse {
    template <typename T>
    T operator()(const airlight::vec3<T>&) const {
        return T(0);
    }
};

/// How far the optical depths may be off that single_scattering takes from differences of outward columns: 64
/// roundoffs of the air from the ray's lowest point outwards, and of the altitudes; of a tent, whose column
/// is a second difference of ramps, the roundoff of its ramps over its width and 2e-4 of the largest column
/// through it.
template <typename T, typename Scene>
airlight::vec3<T> outward_depth_bound(const airlight::Atmosphere<T>& air, const airlight::AirPath<T>& path) {
    const T u = std::numeric_limits<T>::epsilon() / 2;
    const T low = std::fmax(lowest_altitude(path), T(0));
    const auto exponential = [&](T scale_height) {
        // The thinnest layer that the library forms outward columns for.
        const T height = std::fmax(scale_height, T(1e-9L) * (air.ground_radius + air.top_altitude));
        return level_air(air, low, height) * (T(64) * u + altitude_roundoff(air, path, height, u));
    };
    const T edge = air.ozone_altitude + air.ozone_half_width;
    const T width = air.ozone_half_width;
    const T ramps = T(64) * u * (air.ground_radius + edge) * (edge / width);
    const T largest = std::sqrt(T(8) * (air.ground_radius + edge) * width);
    return airlight::column_optical_depth<T, Scene>(
        air, airlight::Column<T>{exponential(air.rayleigh_scale_height), exponential(air.mie_scale_height),
                                 width > T(0) ? ramps + T(4e-4L) * largest : T(0)});
}

/// The stretch of a view ray in the air as the path of its columns.
template <typename T>
airlight::AirPath<T> path_of(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                             const airlight::vec3<T>& direction, const airlight::AirRay<T>& ray) {
    using namespace airlight;
    const T altitude = std::fmax(eye.altitude, T(0));
    const T mu = dot_product(eye.up, direction);
    const vec3<T> across = cross_of_unit_vectors(eye.up, direction);
    const T sine = std::sqrt(dot_product(across, across));
    return AirPath<T>{ray.extent,
                      ray.along,
                      ray.altitude,
                      altitude_along_ray(air.ground_radius, ray.altitude, ray.along, ray.extent),
                      (air.ground_radius + altitude) * sine,
                      altitude * sine - air.ground_radius * (mu * mu / (T(1) + sine))};
}

/// The share of light that single_scattering lets through: less for a longer way. Around planets of ten scale
/// heights and more, its columns are no good for a pebble's air, and of layers that it does not have to make
/// thicker.
template <typename T, typename Scene, typename Integrator>
Verdict transmittance_promises(const Integrator& integrator, const airlight::Atmosphere<T>& air,
                               const airlight::Viewpoint<T>& eye, const airlight::vec3<T>& direction,
                               T distance, T share) {
    using namespace airlight;
    Verdict verdict;
    const AirRay<T> ray = air_ray(air, eye, direction, distance);
    const T thinnest = thinnest_layer<T> * (air.ground_radius + air.top_altitude);
    const T thickest =
        std::fmax(std::fmax(air.rayleigh_scale_height, air.mie_scale_height),
                  Scene::ozone == ozone_none ? T(0) : air.ozone_altitude + air.ozone_half_width);
    const bool has_laws = thickest <= T(0.1L) * air.ground_radius && air.rayleigh_scale_height >= thinnest &&
                          (!Scene::mie || air.mie_scale_height >= thinnest);
    if (!ray.in_air || !has_laws) {
        return verdict;
    }
    const auto passed = [&](T length) {
        return integrator.template view<T, Scene>(air, eye, direction, direction, length, Eclipse{})
            .transmittance;
    };
    const vec3<T> whole = passed(distance);
    const vec3<T> part = passed(ray.begin + share * ray.extent);
    const vec3<T> bound = outward_depth_bound<T, Scene>(air, path_of(air, eye, direction, ray));
    for (int i = 0; i < 3; ++i) {
        if (bound[i] < T(0.5L)) {
            verdict.within("a longer way lets less light through", whole[i] - part[i],
                           part[i] * T(2) * bound[i] + std::numeric_limits<T>::epsilon());
        }
    }
    return verdict;
}

template <typename T, typename Scene, typename Integrator>
Verdict scattering_promises(const Integrator& integrator, const airlight::Atmosphere<T>& air,
                            const airlight::Viewpoint<T>& eye, const airlight::vec3<T>& direction,
                            const airlight::vec3<T>& to_sun, T distance) {
    using namespace airlight;
    Verdict verdict;
    const Scattered<T> seen =
        integrator.template view<T, Scene>(air, eye, direction, to_sun, distance, AlwaysLit{});
    verdict.holds("radiance is an amount", is_amount(seen.radiance));
    verdict.holds("transmittance is a share", is_share(seen.transmittance));

    // A ray scatters at most what it loses, spread at most as the strongest phase function spreads it. In a
    // narrow lobe the last digit of the cosine counts, and a compiler that fuses products rounds it otherwise
    // here than there.
    const T cosine = dot_product(direction, to_sun);
    T strongest = T(0);
    for (const T moved : {T(-2), T(0), T(2)}) {
        const T cos_theta = cosine + moved * std::numeric_limits<T>::epsilon();
        strongest = std::fmax(strongest, rayleigh_phase(cos_theta));
        if constexpr (Scene::mie) {
            strongest = std::fmax(strongest, mie_phase<T, Scene>(cos_theta, air.mie_g));
        }
    }
    const T rounding = T(256) * std::numeric_limits<T>::epsilon();
    for (int i = 0; i < 3; ++i) {
        verdict.within(
            "no light is created", seen.radiance[i],
            strongest * ((T(1) - seen.transmittance[i]) * (T(1) + T(Integrator::energy_excess)) + rounding));
    }

    const Scattered<T> dark =
        integrator.template view<T, Scene>(air, eye, direction, to_sun, distance, Eclipse{});
    verdict.holds("without sunlight there is no light", dark.radiance == vec3<T>(T(0), T(0), T(0)));
#if !defined(__FAST_MATH__) && !defined(__FMA__)
    // Exact: the same operations. A compiler that reorders or fuses them need not do so alike twice.
    verdict.holds("sunlight does not change the transmittance", dark.transmittance == seen.transmittance);
#endif

    const Scattered<T> nothing =
        integrator.template view<T, Scene>(air, eye, direction, to_sun, T(0), AlwaysLit{});
    verdict.holds("no distance adds no light", nothing.radiance == vec3<T>(T(0), T(0), T(0)));
    verdict.holds("no distance takes no light", nothing.transmittance == vec3<T>(T(1), T(1), T(1)));

    const vec3<T> picture = compose(vec3<T>(T(2), T(1), T(0)), seen, vec3<T>(T(0), T(1), T(20)));
    verdict.holds("compose gives an amount", is_amount(picture));
    verdict.holds("exposed is a share", is_share(exposed(picture, T(4))));
    verdict.holds("srgb_from_linear is a share", is_share(srgb_from_linear(picture)));
    return verdict;
}

template <typename T>
std::string told_view(const airlight::Atmosphere<T>& air, const airlight::Viewpoint<T>& eye,
                      const airlight::vec3<T>& direction, const airlight::vec3<T>& to_sun, T distance) {
    return told(air) + told("eye.altitude", eye.altitude) + told("eye.up", eye.up) +
           told("direction", direction) + told("to_sun", to_sun) + told("distance", distance);
}

/// One view in scenes that differ in every term; `share` of its way through the air is a shorter one to
/// compare with.
template <typename T, typename Integrator>
void check_view(Verdict& all, const Integrator& integrator, const airlight::Atmosphere<T>& air,
                const airlight::Viewpoint<T>& eye, const airlight::vec3<T>& direction,
                const airlight::vec3<T>& to_sun, T distance, T share) {
    const auto tell = [&] { return told_view(air, eye, direction, to_sun, distance) + told("share", share); };
    const auto check = [&](auto scene) {
        using Scene = decltype(scene);
        all.add(scattering_promises<T, Scene>(integrator, air, eye, direction, to_sun, distance), tell);
        if constexpr (Integrator::has_columns && Scene::ozone != airlight::ozone_lorentzian) {
            all.add(transmittance_promises<T, Scene>(integrator, air, eye, direction, distance, share), tell);
        }
    };
    check(airlight::DefaultScene{});
    check(LorentzianHenyeyGreenstein{});
    check(Bare{});
}

/// Any view of any planet.
template <typename T, typename Draw, typename Integrator>
void check_any_view(Verdict& all, Draw& draw, const Integrator& integrator) {
    const airlight::Atmosphere<T> air = any_atmosphere<T>(draw);
    const airlight::Viewpoint<T> eye = any_viewpoint(draw, air);
    const airlight::vec3<T> direction = any_direction(draw, air, eye);
    const airlight::vec3<T> to_sun = any_sun(draw, air, eye, direction);
    const T distance = any_distance<T>(draw);
    check_view(all, integrator, air, eye, direction, to_sun, distance, T(zero_or_between(draw, 1e-9, 1.0)));
}

}  // namespace airlight_test
