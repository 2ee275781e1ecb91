#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/spectrum.hpp>

namespace parity {

static const bool king_factor_row =
    row("king_factor")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.number(0.0F, 0.85F, {0.0279F, 0.1F}));
        })
        .cpu([](auto depolarisation) { return airlight::king_factor(depolarisation); })
        .to_the_bit();

static const bool rayleigh_coefficient_row =
    row("rayleigh_coefficient")
        .inputs([](Draw& draw) {
            // In metres: thin to dense gases, near ultraviolet to near infrared.
            return std::make_tuple(draw.magnitude(1e-7F, 1e-2F, {0.0F, 2.78e-4F}),
                                   draw.magnitude(1e20F, 1e28F, {2.547e25F}),
                                   draw.magnitude(2e-7F, 2e-6F, {5.5e-7F}));
        })
        .cpu([](auto refractivity, auto number_density, auto wavelength) {
            return airlight::rayleigh_coefficient(refractivity, number_density, wavelength);
        })
        .to_the_bit();

static const bool absorption_from_albedo_row =
    row("absorption_from_albedo")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.spectrum(1e-8F, 1.0F), draw.number(0.01F, 1.0F, {0.9F}));
        })
        .cpu([](const auto& scattering, auto albedo) {
            return airlight::absorption_from_albedo(scattering, albedo);
        })
        .to_the_bit();

static const bool extinction_from_visibility_row =
    row("extinction_from_visibility")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.magnitude(1e-2F, 1e6F),
                                   draw.number(1e-4F, 1.0F, {0.02F, 0.05F, 0.999F}));
        })
        .cpu([](auto visibility, auto contrast) {
            return airlight::extinction_from_visibility(visibility, contrast);
        })
        .within_bound();

static const bool angstrom_ratio_row =
    row("angstrom_ratio")
        .inputs([](Draw& draw) {
            const float reference = draw.magnitude(0.3F, 3.0F, {0.55F});
            // A wavelength equal to the reference is an edge of its own: the ratio is then 1.
            const float ratio = draw.magnitude(0.1F, 10.0F, {1.0F});
            return std::make_tuple(reference * ratio, reference, draw.number(-4.0F, 4.0F, {0.0F, 1.3F}));
        })
        .cpu([](auto wavelength, auto reference, auto exponent) {
            return airlight::angstrom_ratio(wavelength, reference, exponent);
        })
        .within_bound();

}  // namespace parity
