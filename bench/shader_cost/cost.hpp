#pragma once

#include <functional>
#include <string>
#include <vector>

#include "radv.hpp"

namespace shader_cost {

/// What 64 rays cost that enter every branch and run every pass of every loop.
struct Price {
    Counts counts;
    double latency = 0;             ///< cycles until the wave of these rays is through, waiting included
    double inverse_throughput = 0;  ///< cycles between two such waves when the GPU is full
    double vgprs = 0;
    double sgprs = 0;
    double spilled = 0;  ///< registers that went to memory
    double code_bytes = 0;
};

/// One row of the price list.
struct Row {
    std::string method;
    std::string setting;  ///< steps or nodes, "16" or "16x6"; empty where the method has none
    std::string flags;    ///< "default", or what differs: "mie=0"
    Price price;
    std::string loops;  ///< none, unrolled, extrapolated, pieces or rolled; see README.md
};

/// What to compile for one row.
struct Job {
    std::string method;
    std::string setting;
    std::string flags;
    std::vector<int> counts;                                     ///< passes of the loops, outermost first
    std::function<std::string(const std::vector<int>&)> shader;  ///< GLSL for such counts
    int degree = 1;  ///< 2 where the passes of one count grow with its square
    /// Where a ray falls into pieces, and most passes of the loops over them find none: the passes of these
    /// loops, outermost first, and how many of the innermost find one.
    std::vector<int> piece_passes = {};
    double pieces = 0;
};

/// Cycles that one instruction keeps its unit busy, for a wave of 64 rays.
struct Rates {
    double vector = 0;
    double transcendental = 0;
};

/// Prices jobs by RADV.
class Pricing {
  public:
    explicit Pricing(const Radv& radv);

    /// Compiles a job's shader twice. As it stands: that gives registers and code size. With every loop
    /// unrolled: that gives instructions and cycles as a ray runs them, where a rolled loop would hide them.
    /// Where this code would grow too large, it is compiled with fewer passes, and the cost of the others
    /// added: it is a polynomial in their number, of the job's degree. Loops over pieces stay rolled, and
    /// what lies in them is weighted.
    Row measure(const Job& job) const;

    const Rates& rates() const {
        return rates_;
    }

  private:
    struct Executed {
        Counts counts;
        double latency = 0;
        double radv_inverse_throughput = 0;
        bool loops = false;
    };

    Executed unrolled(const Job& job, std::vector<int> counts) const;
    Executed in_pieces(const Job& job) const;

    const Radv& radv_;
    Rates rates_;
};

}  // namespace shader_cost
