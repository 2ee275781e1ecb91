#pragma once

#include <string>

namespace shader_cost {

/// Into how many lit pieces single_scattering cuts a ray that is lit at all: the mean over the suite of the
/// study. `flags` as in the table; what differs from the default there changes where a ray is cut.
double mean_pieces(const std::string& flags);

/// The same of the sides of its closest approach that a ray in the air has for diffuse_scattering.
double mean_sides();

}  // namespace shader_cost
