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

std::vector<std::uint32_t> with_unrolled_loops(std::vector<std::uint32_t> spirv, Loops loops) {
    constexpr std::size_t header_words = 5;
    constexpr std::uint32_t op_loop_merge =
        246;  // operands: the label behind the loop, another one, the control
    constexpr std::uint32_t op_label = 248;
    constexpr std::uint32_t unroll = 1;
    constexpr std::uint32_t dont_unroll = 2;
    std::vector<std::size_t> open;  // where the OpLoopMerge of the loops around stand, outermost first
    for (std::size_t at = header_words; at < spirv.size();) {
        const std::uint32_t words = spirv[at] >> 16;
        const std::uint32_t op = spirv[at] & 0xffffu;
        if (words == 0 || at + words > spirv.size()) {
            throw support::Error("glslang wrote SPIR-V that ends in the middle of an instruction");
        }
        if (op == op_label) {
            while (!open.empty() && spirv[open.back() + 1] == spirv[at + 1]) {
                open.pop_back();
            }
        }
        if (op == op_loop_merge) {
            if (loops == Loops::innermost && !open.empty()) {
                spirv[open.back() + 3] = dont_unroll;
            }
            spirv[at + 3] = unroll;
            open.push_back(at);
        }
        at += words;
    }
    return spirv;
}

}  // namespace shader_cost
