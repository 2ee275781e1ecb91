#include "spirv.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "support/error.hpp"

namespace shader_cost {
namespace {

/// glslang wants to be told once per process.
class Process {
  public:
    Process() {
        glslang::InitializeProcess();
    }
    ~Process() {
        glslang::FinalizeProcess();
    }
};

}  // namespace

std::vector<std::uint32_t> compile_glsl(const std::string& glsl, const std::string& name) {
    static const Process process;
    glslang::TShader shader(EShLangCompute);
    const char* const text = glsl.c_str();
    shader.setStrings(&text, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    constexpr auto rules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), 450, false, rules)) {
        throw support::Error("glslang refuses the shader of " + name + ": " + shader.getInfoLog());
    }
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(rules)) {
        throw support::Error("glslang cannot link the shader of " + name + ": " + program.getInfoLog());
    }
    std::vector<std::uint32_t> out;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), out);
    return out;
}

std::vector<std::uint32_t> with_unrolled_loops(std::vector<std::uint32_t> spirv) {
    constexpr std::size_t header_words = 5;
    constexpr std::uint32_t op_loop_merge = 246;
    constexpr std::uint32_t loop_control_unroll = 1;
    for (std::size_t at = header_words; at < spirv.size();) {
        const std::uint32_t words = spirv[at] >> 16;
        if ((spirv[at] & 0xffffu) == op_loop_merge && words >= 4) {
            spirv[at + 3] = loop_control_unroll;
        }
        if (words == 0) {
            throw support::Error("glslang wrote SPIR-V that ends in the middle of an instruction");
        }
        at += words;
    }
    return spirv;
}

}  // namespace shader_cost
