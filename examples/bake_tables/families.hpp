#pragma once

// Each family of tables has a file of its own; kinds.cpp puts them together.

#include <vector>

#include "kinds.hpp"

namespace bake_tables {

/// Of tables half of whose rows look at the ground.
inline bool even_height(const support::TableSize& size) {
    return size.height % 2 == 0;
}

std::vector<Kind> transmittance_kinds();
std::vector<Kind> diffuse_kinds();
std::vector<Kind> frame_kinds();
std::vector<Kind> habitat_kinds();
std::vector<Kind> hillaire_kinds();
std::vector<Kind> scattering_kinds();

}  // namespace bake_tables
