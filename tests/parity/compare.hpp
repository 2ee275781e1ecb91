#pragma once

// Runs a row on both sides and keeps the worst that was seen.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "manifest.hpp"
#include "row.hpp"
#include "shader.hpp"

namespace parity {

/// Distance of two floats in representable numbers; 0 and -0 are one number.
std::uint64_t ulps_between(float a, float b);

/// |got - expected| in units of the last place of a float of expected's size (of the smallest normal below
/// that).
double error_in_ulp(double got, double expected);

/// The input at which two evaluations differ most.
struct Worst {
    bool any = false;
    double ulp = 0;       ///< error in float ulp of the expected value
    double relative = 0;  ///< |got - expected| / |expected|; 0 where expected is 0
    double of_bound = 0;  ///< error / bound; what makes it the worst, then ulp
    double expected = 0;
    double got = 0;
    double bound = 0;
    std::size_t component = 0;
    std::vector<float> inputs;
    std::string scene;
};

/// Largest values over all inputs of a row, and the worst input.
struct Tally {
    double max_ulp = 0;
    double max_relative = 0;
    std::size_t compared = 0;
    std::size_t undecided = 0;  ///< not compared: rounding could have turned a branch the other way
    std::size_t outside = 0;    ///< error above the bound
    double max_of_bound = 0;
    Worst worst;
};

struct RowResult {
    const Row* row = nullptr;
    const Function* function = nullptr;
    std::size_t inputs = 0;  ///< calls compared, over all scenes
    std::size_t scenes = 0;
    Tally gpu_float;     ///< GPU against C++ float
    Tally gpu_plain;     ///< the same, compiled as the driver likes, against the specification's bound
    Tally float_double;  ///< C++ float against C++ double
    Tally gpu_double;    ///< GPU against C++ double
    std::size_t above_zero = 0;  ///< results whose derived bound for this driver was above 0
    std::size_t unbounded = 0;   ///< results without a finite bound
    std::vector<std::string> failures;
};

struct Settings {
    std::uint64_t seed = 20220613;
    double share = 1;  ///< of each row's number of inputs
    /// After the first scene that fails; no run without `precise`, no counts of nodes for what passes them
    /// on.
    bool stop_early = false;
    bool webgl = false;  ///< GLSL ES 3.00, once
    /// llvmpipe: + - * / sqrt exact, built-ins as measured. Otherwise the GLSL specification's table.
    bool software_gl = true;
};

/// How a shader is run: its text, the file it tests, the flat inputs, the number of rows, floats per result.
using Runner = std::function<std::vector<float>(const std::string&, const std::string&,
                                                const std::vector<float>&, std::size_t, std::size_t)>;

RowResult run_row(const Row& row, const Function& function, const Manifest& manifest, const GlslFolder& glsl,
                  const Settings& settings, const Runner& run = run_shader);

/// One line per comparison with the worst input, in %a and decimal.
std::string describe(const RowResult& result, const Manifest& manifest);

/// "name = 0.5 (0x1p-1)" for each scalar of the flat inputs; without the hexadecimal form if so asked (nine
/// decimal digits hold every float exactly).
std::string describe_inputs(const Function& function, const Manifest& manifest,
                            const std::vector<float>& inputs, bool hexadecimal = true);

/// The names of a type's scalars: "atmosphere.ground_radius", "direction.x", ...
std::vector<std::string> leaf_names(const Manifest& manifest, const std::string& type,
                                    const std::string& name);

/// %.9g of a float, with its hexadecimal form behind it.
std::string number_text(double x);

}  // namespace parity
