#pragma once

// What every setting costs on a CPU.

#include <vector>

#include "counting.hpp"
#include "errors.hpp"
#include "methods.hpp"

namespace study {

struct Cost {
    Operations operations;             ///< per ray, the mean over the suite
    double nanoseconds;                ///< per ray in float, the median over the rounds
    double ratio;                      ///< of that to the yardstick's, the median over the rounds
    std::vector<double> world_ratios;  ///< the same with each world's rays alone
};

/// The cost of each setting over the suite's rays: operations counted by a scalar that counts, time in float
/// on one thread of the processor's own clock, every setting once a round, in turn.
std::vector<Cost> costs(const std::vector<Setting>& settings, int rounds, const Progress& progress);

}  // namespace study
