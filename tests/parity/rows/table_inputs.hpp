#pragma once

// What the mappings of tables are given.

#include "draw.hpp"

namespace parity {

/// A texture coordinate, or a number a little outside.
inline float coordinate(Draw& draw) {
    return draw.number(-0.25F, 1.25F, {0.0F, 0.5F, 1.0F});
}

inline int table_size(Draw& draw) {
    return draw.one_of({1, 2, 3, 8, 32, 64, 100, 256});
}

inline int even_size(Draw& draw) {
    return draw.one_of({2, 4, 6, 32, 64, 100, 256});
}

/// An altitude in [0, top_altitude].
inline float height_in_air(Draw& draw, const airlight::Atmosphere<float>& atmosphere) {
    return draw.number(0.0F, 1.0F, {1e-6F, 1e-3F}) * atmosphere.top_altitude;
}

}  // namespace parity
