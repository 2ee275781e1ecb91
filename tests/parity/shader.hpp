#pragma once

// The shaders that the test writes: one compute shader per function and scene.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "manifest.hpp"
#include "scenes.hpp"

namespace parity {

/// Where shader text comes from, and what is done to it before it is compiled.
struct GlslFolder {
    std::filesystem::path folder;  ///< holds airlight.glsl and airlight/
    bool one_file = false;         ///< every function from airlight.glsl instead of its own file
};

/// The text of one generated file with its includes replaced, without #version.
std::string expanded(const GlslFolder& glsl, const std::string& file);

/// How a function's shader is compiled; what it takes is added by the test, never to the generated files.
///   pinned: the result is declared `precise`. Without it Mesa factors a * b + a * c; from the result it
///     carries `precise` back through everything that contributes, across function calls.
///   as the driver likes: what a user's shader gets.
///   webgl: the same as a fragment shader of GLSL ES 3.00, inputs in a texture, results four to a pixel.
enum class Compiled { pinned, as_the_driver_likes, webgl };

/// A shader that reads rows of floats, calls `function`, and writes rows of floats.
std::string function_shader(const Manifest& manifest, const Function& function, const GlslFolder& glsl,
                            const SceneName& scene, bool hooked, Compiled compiled);

/// A compute shader for `out[0] = expression`, where the inputs are called x and y.
std::string expression_shader(const std::string& expression, bool precise);

/// Runs a compute shader: `inputs` holds `rows` rows, the result the same number of rows of `per_result`.
/// Throws support::Error with the driver's log when the text does not compile.
std::vector<float> run_shader(const std::string& text, const std::string& name,
                              const std::vector<float>& inputs, std::size_t rows, std::size_t per_result);

/// Compiles a text as a fragment or compute stage; "" or the driver's log.
std::string compile_log(const std::string& text, bool compute);

}  // namespace parity
