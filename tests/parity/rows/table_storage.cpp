#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/table_storage.hpp>

namespace parity {

static auto light(Draw& draw) {
    const float x = draw.magnitude(1e-14F, 65000.0F, {0.0F, 1.0F});
    const float y = draw.magnitude(1e-14F, 65000.0F, {0.0F, 1.0F});
    return std::make_tuple(airlight::vec3<float>(x, y, draw.magnitude(1e-14F, 65000.0F, {0.0F, 1.0F})));
}

static const bool stored_light_row = row("stored_light")
                                         .inputs(light)
                                         .cpu([](const auto& light) { return airlight::stored_light(light); })
                                         .to_the_bit();

static const bool light_from_stored_row =
    row("light_from_stored")
        .inputs([](Draw& draw) {
            const float x = draw.magnitude(6e-5F, 65000.0F, {0.0F, 1.0F});
            const float y = draw.magnitude(6e-5F, 65000.0F, {0.0F, 1.0F});
            return std::make_tuple(
                airlight::vec3<float>(x, y, draw.magnitude(6e-5F, 65000.0F, {0.0F, 1.0F})));
        })
        .cpu([](const auto& stored) { return airlight::light_from_stored(stored); })
        .to_the_bit();

}  // namespace parity
