#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/gauss.hpp>

namespace parity {

static auto sample(Draw& draw) {
    return std::make_tuple(draw.one_of({0, 1, 2, 3}));
}

static const bool gauss_position_row =
    row("gauss_position")
        .inputs(sample)
        .count(64)
        .cpu([](auto run, int i) {
            using R = decltype(run);
            return airlight::gauss_position<typename R::T, typename R::Scene>(i);
        })
        .to_the_bit();

static const bool gauss_weight_row =
    row("gauss_weight")
        .inputs(sample)
        .count(64)
        .cpu([](auto run, int i) {
            using R = decltype(run);
            return airlight::gauss_weight<typename R::T, typename R::Scene>(i);
        })
        .to_the_bit();

}  // namespace parity
