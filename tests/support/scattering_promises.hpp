#pragma once

// What single scattering promises for one view. An integrator is a functor
//     Scattered<T> operator()<T, Scene>(air, eye, direction, to_sun, distance, visibility).

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
    /// By how much its light may exceed what the air takes from the ray: every step's share of it is 2
    /// sinh(tau / 2) / tau or less, so nothing but rounding, which grows with the steps.
    template <typename T>
    T energy_slack() const {
        return T(8 * (steps + 8)) * std::numeric_limits<T>::epsilon();
    }
};

/// Hook: no sunlight reaches any sample.
struct Eclipse {
    template <typename T>
    T operator()(const airlight::vec3<T>&) const {
        return T(0);
    }
};

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
    const T slack = integrator.template energy_slack<T>();
    for (int i = 0; i < 3; ++i) {
        verdict.within("no light is created", seen.radiance[i],
                       strongest * ((T(1) - seen.transmittance[i]) * (T(1) + slack) + slack));
    }

    const Scattered<T> dark =
        integrator.template view<T, Scene>(air, eye, direction, to_sun, distance, Eclipse{});
    verdict.holds("without sunlight there is no light", dark.radiance == vec3<T>(T(0), T(0), T(0)));
    // Exact: the same operations; -ffast-math orders them as it likes.
#ifdef __FAST_MATH__
    const T reordered = std::numeric_limits<T>::epsilon() * T(1024);
#else
    const T reordered = T(0);
#endif
    for (int i = 0; i < 3; ++i) {
        verdict.within("sunlight does not change the transmittance",
                       std::fabs(dark.transmittance[i] - seen.transmittance[i]), reordered);
    }

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

/// One view in scenes that differ in every term.
template <typename T, typename Integrator>
void check_view(Verdict& all, const Integrator& integrator, const airlight::Atmosphere<T>& air,
                const airlight::Viewpoint<T>& eye, const airlight::vec3<T>& direction,
                const airlight::vec3<T>& to_sun, T distance) {
    const auto tell = [&] { return told_view(air, eye, direction, to_sun, distance); };
    all.add(scattering_promises<T, airlight::DefaultScene>(integrator, air, eye, direction, to_sun, distance),
            tell);
    all.add(
        scattering_promises<T, LorentzianHenyeyGreenstein>(integrator, air, eye, direction, to_sun, distance),
        tell);
    all.add(scattering_promises<T, Bare>(integrator, air, eye, direction, to_sun, distance), tell);
}

/// Any view of any planet.
template <typename T, typename Draw, typename Integrator>
void check_any_view(Verdict& all, Draw& draw, const Integrator& integrator) {
    const airlight::Atmosphere<T> air = any_atmosphere<T>(draw);
    const airlight::Viewpoint<T> eye = any_viewpoint(draw, air);
    const airlight::vec3<T> direction = any_direction(draw, air, eye);
    const airlight::vec3<T> to_sun = any_sun(draw, air, eye, direction);
    check_view(all, integrator, air, eye, direction, to_sun, any_distance<T>(draw));
}

}  // namespace airlight_test
