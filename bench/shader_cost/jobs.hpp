#pragma once

#include <string>
#include <vector>

#include "cost.hpp"
#include "shaders.hpp"

namespace shader_cost {

/// Every function of the library, as the default scene has it and with each flag at each other value; those
/// with an `int` parameter at several counts, those with a number of nodes at each number.
std::vector<Job> library_jobs(const Library& library);

/// The methods that airlight is compared with, each at the settings that it is used with; at the first of
/// them with each flag at each other value. Throws support::Error when `baselines` lacks one.
std::vector<Job> baseline_jobs(const Library& baselines);

}  // namespace shader_cost
