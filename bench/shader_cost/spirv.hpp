#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace shader_cost {

/// SPIR-V for Vulkan 1.2 of a compute shader. `name` stands for it in messages.
/// Throws support::Error with glslang's message when it does not compile.
std::vector<std::uint32_t> compile_glsl(const std::string& glsl, const std::string& name);

enum class Loops {
    all,
    innermost,  ///< those without another loop within them, in the same function; others stay rolled
};

/// Asks the driver to unroll loops (SPIR-V's loop control). Mesa then does, whatever the code grows to, as
/// long as it can tell the number of passes.
std::vector<std::uint32_t> with_unrolled_loops(std::vector<std::uint32_t> spirv, Loops loops);

}  // namespace shader_cost
