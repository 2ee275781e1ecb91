#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/arc_tangent.hpp>

namespace parity {

static const bool arc_tangent_row = row("arc_tangent")
                                        .inputs([](Draw& draw) {
                                            const float y = draw.magnitude(1e-6F, 1e6F, {0.0F});
                                            const float x = draw.magnitude(1e-6F, 1e6F, {0.0F});
                                            return std::make_tuple(y, draw.one_of({0, 1}) == 1 ? x : -x);
                                        })
                                        .cpu([](auto y, auto x) { return airlight::arc_tangent(y, x); })
                                        .to_the_bit();

static const bool direction_at_angle_row =
    row("direction_at_angle")
        .inputs([](Draw& draw) {
            const float angle = draw.magnitude(1e-4F, 1.1F, {0.0F});
            return std::make_tuple(draw.one_of({0, 1}) == 1 ? angle : -angle);
        })
        .cpu([](auto angle) { return airlight::direction_at_angle(angle); })
        .to_the_bit();

}  // namespace parity
