#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/chapman.hpp>

namespace parity {

static const bool scaled_erfc_row =
    row("scaled_erfc")
        .inputs([](Draw& draw) { return std::make_tuple(draw.magnitude(1e-6F, 1e6F, {0.0F})); })
        .cpu([](auto x) { return airlight::scaled_erfc(x); })
        .to_the_bit();

static const bool chapman_row =
    row("chapman")
        .inputs([](Draw& draw) {
            const float x = draw.magnitude(0.1F, 1e8F, {50.0F, 800.0F, 5300.0F});
            const float mu = std::abs(draw.cosine());
            return std::make_tuple(x, mu, std::sqrt((1.0F - mu) * (1.0F + mu)));
        })
        .cpu([](auto x, auto mu, auto sine) { return airlight::chapman(x, mu, sine); })
        .to_the_bit();

}  // namespace parity
