#pragma once

#include <string>
#include <vector>

#include "cost.hpp"
#include "shaders.hpp"

namespace shader_cost {

/// A term that is off costs nothing: with a flag off, every function that reads the flag must have fewer
/// instructions than with the flag on, in rows measured of library_jobs. One line for each that has not.
std::vector<std::string> flags_that_save_nothing(const Library& library, const std::vector<Row>& rows);

}  // namespace shader_cost
