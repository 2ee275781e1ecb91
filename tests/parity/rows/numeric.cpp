#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/numeric.hpp>

namespace parity {

static const bool one_minus_exp_row =
    row("one_minus_exp")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.magnitude(1e-30F, 1e3F, {0.0F, 0.5F, 0x1.fffffep-2F}));
        })
        .cpu([](auto x) { return airlight::one_minus_exp(x); })
        .within_bound();

static const bool safe_sqrt_row =
    row("safe_sqrt")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.magnitude(1e-30F, 1e30F, {0.0F, 1.0F, -1e-7F, -1e30F}));
        })
        .cpu([](auto x) { return airlight::safe_sqrt(x); })
        .to_the_bit();

static const bool dot_product_row =
    row("dot_product")
        .inputs([](Draw& draw) {
            const auto a = draw.direction() * draw.magnitude(1e-6F, 1e9F, {0.0F, 1.0F});
            return std::make_tuple(a, draw.direction() * draw.magnitude(1e-6F, 1e9F, {0.0F, 1.0F}));
        })
        .cpu([](const auto& a, const auto& b) { return airlight::dot_product(a, b); })
        .to_the_bit();

static const bool cross_of_unit_vectors_row =
    row("cross_of_unit_vectors")
        .inputs([](Draw& draw) {
            const auto a = draw.direction();
            const auto b = draw.one_of({0, 1}) == 0
                               ? draw.direction()
                               : draw.direction_at(a, static_cast<double>(draw.cosine()));
            return std::make_tuple(a, b);
        })
        .cpu([](const auto& a, const auto& b) { return airlight::cross_of_unit_vectors(a, b); })
        .to_the_bit();

}  // namespace parity
