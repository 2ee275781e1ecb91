#pragma once

// What phase functions, densities, coefficients and colours promise.

#include "extremes.hpp"
#include "promises.hpp"

namespace airlight_test {

/// `droplet_um` is any diameter, `alpha` >= 0 any number.
template <typename T>
Verdict phase_promises(T cos_theta, T g, T alpha, T droplet_um) {
    using namespace airlight;
    Verdict verdict;
    const T peak = g < T(0) ? T(-1) : T(1);
    const T rounding = T(1) + T(32) * std::numeric_limits<T>::epsilon();
    const auto lobe = [&](const char* amount, const char* no_higher, T value, T highest) {
        verdict.holds(amount, is_amount(value));
        verdict.holds(no_higher, value <= highest * rounding);
    };
    lobe("rayleigh_phase is an amount", "rayleigh_phase is highest forward", rayleigh_phase(cos_theta),
         rayleigh_phase(T(1)));
    lobe("henyey_greenstein_phase is an amount", "henyey_greenstein_phase is highest in its peak",
         henyey_greenstein_phase(cos_theta, g), henyey_greenstein_phase(peak, g));
    lobe("cornette_shanks_phase is an amount", "cornette_shanks_phase is highest in its peak",
         cornette_shanks_phase(cos_theta, g), cornette_shanks_phase(peak, g));
    lobe("schlick_phase is an amount", "schlick_phase is highest in its peak", schlick_phase(cos_theta, g),
         schlick_phase(peak, g));
    lobe("draine_phase is an amount", "draine_phase is highest in its peak",
         draine_phase(cos_theta, g, alpha), draine_phase(peak, g, alpha));
    lobe("fog_phase is an amount", "fog_phase is highest forward", fog_phase(cos_theta, droplet_um),
         fog_phase(T(1), droplet_um));
    return verdict;
}

template <typename T>
Verdict density_promises(T altitude, T higher, T centre, T thickness) {
    using namespace airlight;
    Verdict verdict;
    const T exponential = exponential_density(altitude, thickness);
    verdict.holds("exponential_density is a share", is_share(exponential));
    verdict.holds("exponential_density falls with altitude",
                  exponential_density(std::fmax(altitude, higher), thickness) <= exponential);
    verdict.holds("tent_density is a share", is_share(tent_density(altitude, centre, thickness)));
    verdict.holds("lorentzian_density is a share", is_share(lorentzian_density(altitude, centre, thickness)));
    return verdict;
}

template <typename T>
Verdict color_promises(const airlight::vec3<T>& radiance, T exposure,
                       const airlight::vec3<T>& column_and_depth) {
    using namespace airlight;
    Verdict verdict;
    verdict.holds("luminance is an amount", is_amount(luminance(radiance)));
    verdict.holds("exposed is a share", is_share(exposed(radiance, exposure)));
    const vec3<T> encoded = srgb_from_linear(radiance);
    verdict.holds("srgb_from_linear is a share", is_share(encoded));
    verdict.holds("linear_from_srgb is a share", is_share(linear_from_srgb(radiance)));
    const vec3<T> back = linear_from_srgb(encoded);
    for (int i = 0; i < 3; ++i) {
        // Both ways cost 14 ulp by their docstrings, times 2.4, the exponent.
        verdict.within("linear_from_srgb undoes srgb_from_linear",
                       std::fabs(back[i] - std::fmin(radiance[i], T(1))),
                       T(40) * std::numeric_limits<T>::epsilon() * (back[i] + std::numeric_limits<T>::min()) +
                           T(1e-7L) * (back[i] < T(0.01L) ? T(1) : T(0)));
    }
    const vec3<T> glow = ambient_radiance(radiance, column_and_depth.x, column_and_depth);
    verdict.holds("ambient_radiance is an amount", is_amount(glow));
    for (int i = 0; i < 3; ++i) {
        verdict.holds(
            "ambient_radiance is at most its thin limit",
            glow[i] <= radiance[i] * column_and_depth.x * (T(1) + T(4) * std::numeric_limits<T>::epsilon()));
    }
    const T lost = one_minus_exp(column_and_depth.y);
    verdict.holds("one_minus_exp is a share", is_share(lost));
    verdict.holds("one_minus_exp is at most its argument",
                  lost <= column_and_depth.y * (T(1) + T(4) * std::numeric_limits<T>::epsilon()));
    return verdict;
}

/// Refractivities, number densities, wavelengths, albedos and contrasts of their documented domains.
template <typename T>
Verdict spectrum_promises(T depolarisation, T refractivity, T number_density, T wavelength, T reference,
                          T exponent, T share, const airlight::vec3<T>& scattering) {
    using namespace airlight;
    Verdict verdict;
    const T king = king_factor(depolarisation);
    verdict.holds("king_factor is at least 1", is_finite(king) && king >= T(1));
    verdict.holds("rayleigh_coefficient is an amount",
                  is_amount(rayleigh_coefficient(refractivity, number_density, wavelength)));
    verdict.holds("absorption_from_albedo is an amount",
                  is_amount(absorption_from_albedo(scattering, share)));
    verdict.holds("extinction_from_visibility is an amount",
                  is_amount(extinction_from_visibility(wavelength, share)));
    verdict.holds("angstrom_ratio is an amount", is_amount(angstrom_ratio(wavelength, reference, exponent)));
    return verdict;
}

/// Any angle and lobe, altitude and layer, colour, and gas.
template <typename T, typename Draw>
void check_any_light(Verdict& all, Draw& draw) {
    const T cos_theta = cosine<T>(draw);
    const T g = lobe_parameter<T>(draw);
    const T alpha = T(zero_or_between(draw, 1e-6, 1e37));
    const T droplet_um = T(zero_or_between(draw, 1e-6, 1e6));
    all.add(phase_promises(cos_theta, g, alpha, droplet_um), [&] {
        return told("cos_theta", cos_theta) + told("g", g) + told("alpha", alpha) +
               told("droplet_um", droplet_um);
    });

    const T altitude = T(draw.below(2) * 2 - 1) * T(zero_or_between(draw, 1e-6, 1e12));
    const T higher = T(zero_or_between(draw, 1e-6, 1e12));
    const T centre = T(zero_or_between(draw, 1e-6, 1e12));
    const T thickness = T(zero_or_between(draw, 1e-30, 1e12));
    all.add(density_promises(altitude, higher, centre, thickness), [&] {
        return told("altitude", altitude) + told("higher", higher) + told("centre", centre) +
               told("thickness", thickness);
    });

    const airlight::vec3<T> radiance(T(zero_or_between(draw, 1e-30, 1e13)),
                                     T(zero_or_between(draw, 1e-30, 1e13)), T(draw.unit()));
    const airlight::vec3<T> air(T(zero_or_between(draw, 1e-30, 1e13)), T(zero_or_between(draw, 1e-30, 1e30)),
                                T(draw.unit()));
    const T exposure = T(zero_or_between(draw, 1e-30, 1e30));
    all.add(color_promises(radiance, exposure, air), [&] {
        return told("radiance", radiance) + told("exposure", exposure) + told("column and depth", air);
    });

    const T depolarisation = T(draw.uniform(0.0, 0.857142));
    const T refractivity = T(zero_or_between(draw, 1e-9, 1.0));
    const T number_density = T(end_or_between(draw, 1.0, 1e30));
    const T wavelength = T(end_or_between(draw, 1e-8, 1e4));
    const T reference = T(end_or_between(draw, 1e-8, 1e4));
    const T exponent = T(draw.uniform(-3.0, 3.0));
    const T share = T(end_or_between(draw, 1e-9, 1.0));
    all.add(spectrum_promises(depolarisation, refractivity, number_density, wavelength, reference, exponent,
                              share, radiance),
            [&] {
                return told("depolarisation", depolarisation) + told("refractivity", refractivity) +
                       told("number_density", number_density) + told("wavelength", wavelength) +
                       told("reference", reference) + told("exponent", exponent) + told("share", share) +
                       told("scattering", radiance);
            });
}

}  // namespace airlight_test
