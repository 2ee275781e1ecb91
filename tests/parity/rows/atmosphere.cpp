#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/atmosphere.hpp>
#include <airlight/atmospheres.hpp>

namespace parity {

static const bool rescaled_row =
    row("rescaled")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            return std::make_tuple(atmosphere, draw.magnitude(1e-4F, 1e4F, {1e-3F, 1.0F, 1024.0F}));
        })
        .cpu([](const auto& atmosphere, auto factor) { return airlight::rescaled(atmosphere, factor); })
        .to_the_bit();

static const bool earth_row = row("earth")
                                  .no_inputs()
                                  .cpu([](auto run) { return airlight::earth<typename decltype(run)::T>(); })
                                  .to_the_bit();

static const bool cs562_earth_row =
    row("cs562_earth")
        .no_inputs()
        .cpu([](auto run) { return airlight::cs562_earth<typename decltype(run)::T>(); })
        .to_the_bit();

static const bool elek_earth_row =
    row("elek_earth")
        .no_inputs()
        .cpu([](auto run) { return airlight::elek_earth<typename decltype(run)::T>(); })
        .to_the_bit();

static const bool leenman_earth_row =
    row("leenman_earth")
        .no_inputs()
        .cpu([](auto run) { return airlight::leenman_earth<typename decltype(run)::T>(); })
        .to_the_bit();

static const bool mars_row = row("mars")
                                 .no_inputs()
                                 .cpu([](auto run) { return airlight::mars<typename decltype(run)::T>(); })
                                 .to_the_bit();

}  // namespace parity
