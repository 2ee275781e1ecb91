#pragma once

// The shaders whose cost is measured: one call each, of a function that a manifest names.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "support/manifest.hpp"
#include "variants.hpp"

namespace shader_cost {

/// Where a shader's resources are bound, in descriptor set 0.
namespace binding {
constexpr std::uint32_t inputs = 0;      ///< storage buffer: what differs from ray to ray
constexpr std::uint32_t results = 1;     ///< storage buffer
constexpr std::uint32_t atmosphere = 2;  ///< uniform buffer: the same for every ray
constexpr std::uint32_t table = 3;       ///< sampled images from here on: what a table hook reads
constexpr std::uint32_t tables = 3;      ///< how many
constexpr std::uint32_t sizes = 6;       ///< uniform buffer: of tables
}  // namespace binding

/// Generated GLSL and the manifest that describes it.
struct Library {
    support::Manifest manifest;
    std::vector<std::filesystem::path> folders;  ///< searched in this order for what a file includes
};

/// A compute shader in which every invocation reads its inputs from a buffer, calls `function` and writes all
/// of its result. A hook that takes texture coordinates reads a texture. An Atmosphere comes from a uniform
/// block, and the function's `int` parameters are the constants `counts`, in their order, then 1.
///
/// With `tables`, a value of TABLES as TABLES_DIFFUSE, the other hooks are those of the deferred renderer.
std::string function_shader(const Library& library, const support::Function& function,
                            const std::vector<bench::FlagValue>& flags, const std::vector<int>& counts,
                            const std::string& tables = "");

}  // namespace shader_cost
