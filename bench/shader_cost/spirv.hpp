#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace shader_cost {

/// SPIR-V for Vulkan 1.2 of a compute shader. `name` stands for it in messages.
/// Throws support::Error with glslang's message when it does not compile.
std::vector<std::uint32_t> compile_glsl(const std::string& glsl, const std::string& name);

/// Asks the driver to unroll every loop (SPIR-V's loop control). Mesa then does, whatever the code grows to,
/// as long as it can tell the number of passes.
std::vector<std::uint32_t> with_unrolled_loops(std::vector<std::uint32_t> spirv);

}  // namespace shader_cost
