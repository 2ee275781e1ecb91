#include "cost.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "spirv.hpp"

namespace shader_cost {
namespace {

/// More passes than this are not unrolled: Mesa's time and memory grow with the code.
constexpr int most_passes = 128;
/// The two numbers of passes from which others follow. From 8 on, one pass more costs the same.
constexpr int few = 8;
constexpr int twice_as_many = 16;

/// What grows with the passes.
constexpr double Statistics::*executed[] = {&Statistics::instructions,   &Statistics::vector,
                                            &Statistics::transcendental, &Statistics::every_branch,
                                            &Statistics::latency,        &Statistics::inverse_throughput};

int passes(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 1, [](int a, int b) { return a * b; });
}

/// Loops of few passes are unrolled, however they are nested.
bool is_extrapolated(const std::vector<int>& counts) {
    return passes(counts) > most_passes &&
           std::any_of(counts.begin(), counts.end(), [](int count) { return count > twice_as_many; });
}

/// a at `few` and b at `twice_as_many` passes: what it is at `count`.
double extrapolated(double a, double b, int count) {
    return a + (b - a) * (count - few) / (twice_as_many - few);
}

Statistics unrolled(const Radv& radv, const Job& job, std::vector<int> counts) {
    if (!is_extrapolated(counts)) {
        return radv.compile(with_unrolled_loops(compile_glsl(job.shader(counts), job.method)));
    }
    int& longest = *std::max_element(counts.begin(), counts.end());
    const int count = longest;
    longest = few;
    const Statistics a = unrolled(radv, job, counts);
    longest = twice_as_many;
    Statistics out = unrolled(radv, job, counts);
    for (double Statistics::*const member : executed) {
        out.*member = extrapolated(a.*member, out.*member, count);
    }
    out.loops = out.loops || a.loops;
    return out;
}

}  // namespace

Row measure(const Radv& radv, const Job& job) {
    const Statistics plain = radv.compile(compile_glsl(job.shader(job.counts), job.method));
    Row row{job.method, job.setting, job.flags, unrolled(radv, job, job.counts), ""};
    for (double Statistics::*const member : executed) {
        row.statistics.*member = std::round(row.statistics.*member);
    }
    row.loops = row.statistics.loops          ? "rolled"
                : is_extrapolated(job.counts) ? "extrapolated"
                : plain.loops                 ? "unrolled"
                                              : "none";
    row.statistics.code_bytes = plain.code_bytes;
    row.statistics.sgprs = plain.sgprs;
    row.statistics.vgprs = plain.vgprs;
    row.statistics.spilled = plain.spilled;
    return row;
}

}  // namespace shader_cost
