#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/habitats.hpp>

namespace parity {

static const bool rama_air_row =
    row("rama_air")
        .no_inputs()
        .cpu([](auto run) { return airlight::rama_air<typename decltype(run)::T>(); })
        .to_the_bit();

static const bool rama_lights_row =
    row("rama_lights")
        .no_inputs()
        .cpu([](auto run) { return airlight::rama_lights<typename decltype(run)::T>(); })
        .to_the_bit();

}  // namespace parity
