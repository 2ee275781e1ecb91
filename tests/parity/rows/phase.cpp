#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/phase.hpp>

namespace parity {

static const bool isotropic_phase_row =
    row("isotropic_phase")
        .no_inputs()
        .cpu([](auto run) { return airlight::isotropic_phase<typename decltype(run)::T>(); })
        .to_the_bit();

static const bool rayleigh_phase_row =
    row("rayleigh_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine()); })
        .cpu([](auto cos_theta) { return airlight::rayleigh_phase(cos_theta); })
        .to_the_bit();

// g short of 1 and -1, where the functions divide by zero, and 0, where they are flat.
static float lobe(Draw& draw) {
    return draw.number(-0.999F, 0.999F, {0.0F, 0.76F, 0.8F, 1e-6F});
}

static const bool henyey_greenstein_denominator_row =
    row("henyey_greenstein_denominator")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.cosine(), draw.number(-1.0F, 1.0F, {0.0F, 0.76F}));
        })
        .cpu([](auto cos_theta, auto g) { return airlight::henyey_greenstein_denominator(cos_theta, g); })
        .to_the_bit();

static const bool henyey_greenstein_phase_row =
    row("henyey_greenstein_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine(), lobe(draw)); })
        .cpu([](auto cos_theta, auto g) { return airlight::henyey_greenstein_phase(cos_theta, g); })
        .to_the_bit();

static const bool cornette_shanks_phase_row =
    row("cornette_shanks_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine(), lobe(draw)); })
        .cpu([](auto cos_theta, auto g) { return airlight::cornette_shanks_phase(cos_theta, g); })
        .to_the_bit();

static const bool schlick_phase_row =
    row("schlick_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine(), lobe(draw)); })
        .cpu([](auto cos_theta, auto k) { return airlight::schlick_phase(cos_theta, k); })
        .to_the_bit();

static const bool draine_phase_row =
    row("draine_phase")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.cosine(), lobe(draw), draw.number(0.0F, 30.0F, {1.0F}));
        })
        .cpu([](auto cos_theta, auto g, auto alpha) { return airlight::draine_phase(cos_theta, g, alpha); })
        .to_the_bit();

static const bool fog_phase_row =
    row("fog_phase")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.cosine(), draw.number(5.0F, 50.0F, {0.0F, 4.0F, 60.0F}));
        })
        .cpu([](auto cos_theta, auto diameter) { return airlight::fog_phase(cos_theta, diameter); })
        .within_bound();

static const bool sample_rayleigh_phase_row =
    row("sample_rayleigh_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.number(0.0F, 1.0F, {0.5F})); })
        .cpu([](auto u) { return airlight::sample_rayleigh_phase(u); })
        .within_bound();

static const bool sample_henyey_greenstein_phase_row =
    row("sample_henyey_greenstein_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.number(0.0F, 1.0F, {0.5F}), lobe(draw)); })
        .cpu([](auto u, auto g) { return airlight::sample_henyey_greenstein_phase(u, g); })
        .to_the_bit();

static const bool mie_phase_row =
    row("mie_phase")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine(), draw.aerosol_parameter()); })
        .cpu([](auto run, auto cos_theta, auto g) {
            using R = decltype(run);
            return airlight::mie_phase<typename R::T, typename R::Scene>(cos_theta, g);
        })
        .within_bound();

}  // namespace parity
