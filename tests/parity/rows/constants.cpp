#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/constants.hpp>

namespace parity {

static const bool no_surface_row =
    row("no_surface")
        .no_inputs()
        .cpu([](auto run) { return airlight::no_surface<typename decltype(run)::T>(); })
        .note(
            "infinite in C++, 1e30 in GLSL, which has no infinity: these two, and only these, count as "
            "equal; "
            "an infinite distance among the inputs of other rows reaches the shader as 1e30")
        .to_the_bit();

}  // namespace parity
