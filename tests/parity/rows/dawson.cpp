#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/dawson.hpp>

namespace parity {

static const bool dawson_row = row("dawson")
                                   .inputs([](Draw& draw) {
                                       const float x = draw.magnitude(1e-6F, 1e6F, {0.0F, 300.0F});
                                       return std::make_tuple(draw.one_of({0, 1}) == 1 ? x : -x);
                                   })
                                   .cpu([](auto x) { return airlight::dawson(x); })
                                   .to_the_bit();

}  // namespace parity
