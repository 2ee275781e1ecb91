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

int product(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 1, [](int a, int b) { return a * b; });
}

/// Loops of few passes are unrolled, however they are nested.
bool is_extrapolated(const Job& job, const std::vector<int>& counts) {
    const auto many = [&](int count) { return count > few * (job.degree + 1); };
    return (product(counts) > most_passes || job.degree > 1) &&
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

void add(Counts& sum, double times, const Counts& counts) {
    sum.instructions += times * counts.instructions;
    sum.vector += times * counts.vector;
    sum.transcendental += times * counts.transcendental;
}

/// How often RADV's estimates take a block to run: loops 8 times, in a loop 4 times each, further in twice; a
/// divergent branch three times in four.
double guessed_runs(const Block& block) {
    const double passes[] = {1, 8, 32, 64, 128};
    return passes[std::min(block.loops, 4)] * std::pow(0.75, block.conditions);
}

/// The factor from RADV's guesses to what runs, by the vector instructions.
double correction(const Compiled& compiled, const Counts& executed) {
    double guessed = 0;
    for (const Block& block : compiled.blocks) {
        guessed += guessed_runs(block) * block.counts.vector;
    }
    return guessed > 0 ? executed.vector / guessed : 1;
}

/// A shader that does one thing to a number, `times` times.
std::string repeated(const std::string& statement, int times) {
    std::string out =
        "#version 450 core\n"
        "layout(local_size_x = 64) in;\n"
        "layout(std430, binding = 0) readonly buffer Inputs { float in_data[]; };\n"
        "layout(std430, binding = 1) writeonly buffer Results { float out_data[]; };\n"
        "void main() {\n"
        "    float x = in_data[gl_GlobalInvocationID.x];\n"
        "    float y = x;\n";
    for (int i = 0; i < times; ++i) {
        out += "    " + statement + "\n";
    }
    return out + "    out_data[gl_GlobalInvocationID.x] = x;\n}\n";
}

/// Cycles of one instruction when the GPU is full, from shaders that have many of nothing else.
double rate(const Radv& radv, const std::string& statement) {
    const auto cycles = [&](int times) {
        return radv.compile(compile_glsl(repeated(statement, times), statement)).inverse_throughput;
    };
    return (cycles(2000) - cycles(1000)) / 1000;
}

}  // namespace

Pricing::Pricing(const Radv& radv)
    : radv_(radv), rates_{rate(radv, "x = fma(x, y, y);"), rate(radv, "x = exp2(x);")} {}

Pricing::Executed Pricing::unrolled(const Job& job, std::vector<int> counts) const {
    if (!is_extrapolated(job, counts)) {
        const Compiled compiled =
            radv_.compile(with_unrolled_loops(compile_glsl(job.shader(counts), job.method), Loops::all));
        return {compiled.counts, compiled.latency * correction(compiled, compiled.counts),
                compiled.inverse_throughput, compiled.has_loops()};
    }
    int& longest = *std::max_element(counts.begin(), counts.end());
    const int count = longest;
    std::vector<int> points;
    for (int i = 1; i <= job.degree + 1; ++i) {
        points.push_back(few * i);
    }
    Executed out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        longest = points[i];
        const Executed fewer = unrolled(job, counts);
        const double share = lagrange(points, i, count);
        add(out.counts, share, fewer.counts);
        out.latency += share * fewer.latency;
        out.radv_inverse_throughput += share * fewer.radv_inverse_throughput;
        out.loops = out.loops || fewer.loops;
    }
    return out;
}

Pricing::Executed Pricing::in_pieces(const Job& job) const {
    const Compiled compiled = radv_.compile(
        with_unrolled_loops(compile_glsl(job.shader(job.counts), job.method), Loops::innermost));
    const int deepest = static_cast<int>(job.piece_passes.size());
    Executed out;
    for (const Block& block : compiled.blocks) {
        // Tests run at every pass; what they guard runs once, in the innermost loop once for each piece.
        double runs = 1;
        if (block.loops > deepest) {
            out.loops = true;
        } else if (block.conditional) {
            runs = block.loops == deepest ? job.pieces : 1;
        } else {
            runs = product({job.piece_passes.begin(), job.piece_passes.begin() + block.loops});
        }
        add(out.counts, runs, block.counts);
    }
    out.latency = compiled.latency * correction(compiled, out.counts);
    return out;
}

Row Pricing::measure(const Job& job) const {
    const Compiled plain = radv_.compile(compile_glsl(job.shader(job.counts), job.method));
    const bool pieces = !job.piece_passes.empty();
    const Executed executed = pieces ? in_pieces(job) : unrolled(job, job.counts);
    Row row{job.method, job.setting, job.flags, {}, ""};
    add(row.price.counts, 1, executed.counts);
    row.price.latency = executed.latency;
    // RADV's own figure is the larger one where memory or the number of waves is the limit.
    row.price.inverse_throughput =
        std::max({executed.radv_inverse_throughput, rates_.vector * executed.counts.vector,
                  rates_.transcendental * executed.counts.transcendental});
    row.price.vgprs = plain.vgprs;
    row.price.sgprs = plain.sgprs;
    row.price.spilled = plain.spilled;
    row.price.code_bytes = plain.code_bytes;
    row.loops = executed.loops                     ? "rolled"
                : pieces                           ? "pieces"
                : is_extrapolated(job, job.counts) ? "extrapolated"
                : plain.has_loops()                ? "unrolled"
                                                   : "none";
    return row;
}

}  // namespace shader_cost
