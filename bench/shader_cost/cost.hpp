#pragma once

#include <functional>
#include <string>
#include <vector>

#include "radv.hpp"

namespace shader_cost {

/// One row of the price list.
struct Row {
    std::string method;
    std::string setting;  ///< steps or nodes, "16" or "16x6"; empty where the method has none
    std::string flags;    ///< "default", or what differs: "mie=0"
    Statistics statistics;
    std::string loops;  ///< none, unrolled, extrapolated or rolled; see README.md
};

/// What to compile for one row.
struct Job {
    std::string method;
    std::string setting;
    std::string flags;
    std::vector<int> counts;                                     ///< passes of the loops, outermost first
    std::function<std::string(const std::vector<int>&)> shader;  ///< GLSL for such counts
    int degree = 1;  ///< 2 where the passes of one count grow with its square
};

/// Compiles a job's shader twice. As it stands: that gives registers and code size. With every loop unrolled:
/// that gives instructions and cycles as one ray runs them, where a rolled loop would hide them. Where this
/// code would grow too large, it is compiled with fewer passes, and the cost of the others added: it is a
/// polynomial in their number, of the job's degree.
Row measure(const Radv& radv, const Job& job);

}  // namespace shader_cost
