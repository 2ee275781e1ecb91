#include "cost.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "spirv.hpp"

namespace shader_cost {
namespace {

/// More passes than this are not unrolled: Mesa's time and memory grow with the code.
constexpr int most_passes = 128;
/// Fewer passes are `few`, twice `few` and so on: from 8 on, one pass more costs the same.
constexpr int few = 8;

/// What grows with the passes.
constexpr double Statistics::*executed[] = {&Statistics::instructions,   &Statistics::vector,
                                            &Statistics::transcendental, &Statistics::every_branch,
                                            &Statistics::latency,        &Statistics::inverse_throughput};

int passes(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 1, [](int a, int b) { return a * b; });
}

/// Loops of few passes are unrolled, however they are nested.
bool is_extrapolated(const Job& job, const std::vector<int>& counts) {
    const auto many = [&](int count) { return count > few * (job.degree + 1); };
    return (passes(counts) > most_passes || job.degree > 1) &&
           std::any_of(counts.begin(), counts.end(), many);
}

/// Lagrange's polynomial that is 1 at points[i] and 0 at the other points, at x.
double lagrange(const std::vector<int>& points, std::size_t i, int x) {
    double out = 1;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (k != i) {
            out *= double(x - points[k]) / double(points[i] - points[k]);
        }
    }
    return out;
}

Statistics unrolled(const Radv& radv, const Job& job, std::vector<int> counts) {
    if (!is_extrapolated(job, counts)) {
        return radv.compile(with_unrolled_loops(compile_glsl(job.shader(counts), job.method)));
    }
    int& longest = *std::max_element(counts.begin(), counts.end());
    const int count = longest;
    std::vector<int> points;
    for (int i = 1; i <= job.degree + 1; ++i) {
        points.push_back(few * i);
    }
    Statistics out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        longest = points[i];
        const Statistics fewer = unrolled(radv, job, counts);
        for (double Statistics::*const member : executed) {
            out.*member += lagrange(points, i, count) * fewer.*member;
        }
        out.loops = out.loops || fewer.loops;
    }
    return out;
}

}  // namespace

Row measure(const Radv& radv, const Job& job) {
    const Statistics plain = radv.compile(compile_glsl(job.shader(job.counts), job.method));
    Row row{job.method, job.setting, job.flags, unrolled(radv, job, job.counts), ""};
    for (double Statistics::*const member : executed) {
        row.statistics.*member = std::round(row.statistics.*member);
    }
    row.loops = row.statistics.loops               ? "rolled"
                : is_extrapolated(job, job.counts) ? "extrapolated"
                : plain.loops                      ? "unrolled"
                                                   : "none";
    row.statistics.code_bytes = plain.code_bytes;
    row.statistics.sgprs = plain.sgprs;
    row.statistics.vgprs = plain.vgprs;
    row.statistics.spilled = plain.spilled;
    return row;
}

}  // namespace shader_cost
