#include "builtins.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "bounded.hpp"
#include "compare.hpp"
#include "draw.hpp"
#include "shader.hpp"

namespace parity {
namespace {

constexpr std::size_t samples = 1U << 20U;

using Exact = std::function<double(double, double)>;

struct Measurement {
    std::vector<float> inputs;  // x, y, x, y, ...
    std::vector<float> got;
};

Measurement measure(const std::string& expression, std::uint64_t seed,
                    const std::function<void(Draw&, float&, float&)>& draw_inputs, bool precise = true) {
    Measurement out;
    out.inputs.reserve(2 * samples);
    for (std::size_t i = 0; i < samples; ++i) {
        // Numbered so that every sixteenth is an end point; the rest is stratified.
        Draw draw(seed, i + samples / 4, samples);
        float x = 0;
        float y = 0;
        draw_inputs(draw, x, y);
        out.inputs.push_back(x);
        out.inputs.push_back(y);
    }
    out.got = run_shader(expression_shader(expression, precise), expression, out.inputs, samples, 1);
    return out;
}

/// Errors against the exact value; `note` files them, `allowed` is the specification's bound.
BuiltinRow tally(const std::string& name, const std::string& range, const Measurement& m, const Exact& exact,
                 const std::function<double(double, double)>& allowed,
                 const std::function<void(double, double, double)>& note, bool absolute) {
    BuiltinRow row;
    row.name = name;
    row.range = range;
    row.inputs = samples;
    double worst = -1;
    for (std::size_t i = 0; i < samples; ++i) {
        const auto x = static_cast<double>(m.inputs[2 * i]);
        const auto y = static_cast<double>(m.inputs[2 * i + 1]);
        const double expected = exact(x, y);
        const auto got = static_cast<double>(m.got[i]);
        if (std::abs(expected) < 4 * smallest_normal && !absolute) {
            continue;  // flushed, or on the way there; the bounds allow for that on their own
        }
        const double error = std::abs(got - expected);
        const double relative = error / std::abs(expected);
        note(x, relative, error);
        row.max_relative = expected != 0 ? std::max(row.max_relative, relative) : row.max_relative;
        row.max_absolute = std::max(row.max_absolute, error);
        const double limit = allowed(x, y);
        row.specification = limit > 0 ? std::max(row.specification, error / limit) : row.specification;
        if ((absolute ? error : relative) > worst) {
            worst = absolute ? error : relative;
            row.at_x = x;
            row.at_y = y;
        }
    }
    return row;
}

OperationRow compare_operation(const std::string& glsl, const std::string& cpp, std::uint64_t seed,
                               const std::function<void(Draw&, float&, float&)>& draw_inputs,
                               const std::function<float(float, float)>& expected) {
    OperationRow row;
    row.glsl = glsl;
    row.cpp = cpp;
    row.inputs = samples;
    for (const bool precise : {true, false}) {
        const Measurement m = measure(glsl, seed, draw_inputs, precise);
        for (std::size_t i = 0; i < samples; ++i) {
            const std::uint64_t d = ulps_between(expected(m.inputs[2 * i], m.inputs[2 * i + 1]), m.got[i]);
            std::size_t& different = precise ? row.different : row.different_if_not_precise;
            different += d == 0 ? 0 : 1;
            if (precise) {
                row.max_ulp = std::max(row.max_ulp, d);
            }
        }
    }
    return row;
}

}  // namespace

BuiltinReport measure_builtins(std::uint64_t seed) {
    BuiltinReport report;
    DriverErrors& errors = driver_errors();
    const auto nothing = [](double, double, double) {};
    const auto ulp_of = [](double value) { return spec::ulp * std::abs(value); };

    const auto exponents = [](Draw& draw, float& x, float&) {
        const float size = draw.magnitude(1e-7F, 88.0F, {0.0F, 1.0F, 0.5F});
        x = draw.one_of({0, 0, 0, 1}) == 0 ? -size : size;  // transmittance: mostly downwards
    };
    report.builtins.push_back(tally(
        "exp(x)", "-88 to 88", measure("exp(x)", seed, exponents),
        [](double x, double) { return std::exp(x); },
        [&](double x, double) { return spec::exp(x) * ulp_of(std::exp(x)); },
        [&](double x, double relative, double) { errors.exp.add(std::abs(x), relative); }, false));
    report.builtins.push_back(tally(
        "exp2(x)", "-88 to 88", measure("exp2(x)", seed, exponents),
        [](double x, double) { return std::exp2(x); },
        [&](double x, double) { return spec::exp(x) * ulp_of(std::exp2(x)); },
        [&](double x, double relative, double) { errors.exp2.add(std::abs(x), relative); }, false));

    // Both sides of 1, down to the last bits: there a logarithm has few digits of its own.
    const auto around_one = [](Draw& draw, float& x, float&) {
        const float off = draw.magnitude(0x1p-23F, 1e30F, {1.0F});
        x = 1.0F + off;
        if (draw.one_of({0, 1}) == 0) {
            x = 1.0F / x;
        }
    };
    const auto log_allowed = [&](double x, double value) {
        return x >= 0.5 && x <= 2 ? spec::log_near_one : spec::log * ulp_of(value);
    };
    report.builtins.push_back(tally(
        "log(x)", "1e-30 to 1e30", measure("log(x)", seed, around_one),
        [](double x, double) { return std::log(x); },
        [&](double x, double) { return log_allowed(x, std::log(x)); },
        [&](double x, double, double error) { errors.log.add(distance_from_one(x), error); }, true));
    report.builtins.push_back(tally(
        "log2(x)", "1e-30 to 1e30", measure("log2(x)", seed, around_one),
        [](double x, double) { return std::log2(x); },
        [&](double x, double) { return log_allowed(x, std::log2(x)); },
        [&](double x, double, double error) { errors.log2.add(distance_from_one(x), error); }, true));

    const auto powers = [](Draw& draw, float& x, float& y) {
        x = draw.magnitude(1e-4F, 1e2F, {1.0F});
        y = draw.number(-4.0F, 4.0F, {1.0F, 2.4F});
    };
    report.builtins.push_back(tally(
        "pow(x, y)", "x 1e-4 to 100, y -4 to 4", measure("pow(x, y)", seed, powers),
        [](double x, double y) { return std::pow(x, y); },
        [&](double x, double y) {
            // Inherited from exp2(y * log2(x)).
            const double log2_x = std::log2(x);
            const double exponent = std::abs(y) * log_allowed(x, log2_x) + std::abs(y * log2_x) * spec::ulp;
            return std::pow(x, y) * (0.6931472 * exponent + spec::exp(y * log2_x) * spec::ulp);
        },
        nothing, false));

    const auto pairs = [](Draw& draw, float& x, float& y) {
        x = draw.magnitude(1e-8F, 1e8F) * static_cast<float>(draw.one_of({-1, 1}));
        y = draw.magnitude(1e-8F, 1e8F) * static_cast<float>(draw.one_of({-1, 1}));
    };
    const auto positive = [](Draw& draw, float& x, float& y) {
        x = draw.magnitude(1e-30F, 1e30F);
        y = draw.magnitude(1e-8F, 1e8F);
    };
    using V = glm::vec3;
    auto& ops = report.operations;
    ops.push_back(compare_operation("x / y", "x / y", seed, pairs, [](float x, float y) { return x / y; }));
    ops.push_back(
        compare_operation("1.0 / x", "1.0F / x", seed, pairs, [](float x, float) { return 1.0F / x; }));
    ops.push_back(compare_operation("sqrt(x)", "std::sqrt(x)", seed, positive,
                                    [](float x, float) { return std::sqrt(x); }));
    ops.push_back(compare_operation("inversesqrt(x)", "1.0F / std::sqrt(x)", seed, positive,
                                    [](float x, float) { return 1.0F / std::sqrt(x); }));
    ops.push_back(compare_operation("x * y + (x - y)", "x * y + (x - y), rounded twice", seed, pairs,
                                    [](float x, float y) {
                                        const float product = x * y;
                                        const float difference = x - y;
                                        return product + difference;
                                    }));
    ops.push_back(compare_operation("x * 0.3 + x * y", "x * 0.3F + x * y, not factored", seed, pairs,
                                    [](float x, float y) {
                                        const float a = x * 0.3F;
                                        const float b = x * y;
                                        return a + b;
                                    }));
    // Mesa sums a dot product from the last component to the first, precise or not.
    ops.push_back(compare_operation("dot(vec3(x, y, x + y), vec3(y, x - y, x))", "z + y + x of the products",
                                    seed, pairs, [](float x, float y) {
                                        const V products = V(x, y, x + y) * V(y, x - y, x);
                                        return products.z + products.y + products.x;
                                    }));
    ops.push_back(
        compare_operation("dot(vec3(x, y, x + y), vec3(y, x - y, x))", "glm::dot", seed, pairs,
                          [](float x, float y) { return glm::dot(V(x, y, x + y), V(y, x - y, x)); }));
    ops.push_back(
        compare_operation("cross(vec3(x, y, x + y), vec3(y, x - y, x)).x", "glm::cross, x", seed, pairs,
                          [](float x, float y) { return glm::cross(V(x, y, x + y), V(y, x - y, x)).x; }));
    ops.push_back(
        compare_operation("cross(vec3(x, y, x + y), vec3(y, x - y, x)).y", "glm::cross, y", seed, pairs,
                          [](float x, float y) { return glm::cross(V(x, y, x + y), V(y, x - y, x)).y; }));
    ops.push_back(
        compare_operation("cross(vec3(x, y, x + y), vec3(y, x - y, x)).z", "glm::cross, z", seed, pairs,
                          [](float x, float y) { return glm::cross(V(x, y, x + y), V(y, x - y, x)).z; }));
    ops.push_back(compare_operation("length(vec3(x, y, x + y))", "glm::length", seed, pairs,
                                    [](float x, float y) { return glm::length(V(x, y, x + y)); }));
    ops.push_back(compare_operation("normalize(vec3(x, y, x + y)).y", "glm::normalize, y", seed, pairs,
                                    [](float x, float y) { return glm::normalize(V(x, y, x + y)).y; }));
    ops.push_back(compare_operation("mix(x, y, 0.3)", "glm::mix(x, y, 0.3F)", seed, pairs,
                                    [](float x, float y) { return glm::mix(x, y, 0.3F); }));
    ops.push_back(compare_operation("(vec3(x, y, x) / y).x", "(glm::vec3(x, y, x) / y).x", seed, pairs,
                                    [](float x, float y) { return (V(x, y, x) / y).x; }));
    return report;
}

}  // namespace parity
