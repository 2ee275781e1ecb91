#include "shader.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <sstream>

#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"
#include "support/gl_objects.hpp"
#include "support/glsl_source.hpp"
#include "support/glsl_values.hpp"

namespace parity {
namespace {

constexpr int group_size = 64;

std::string buffers(std::size_t per_input, std::size_t per_result) {
    std::ostringstream out;
    out << "layout(local_size_x = " << group_size << ") in;\n"
        << "layout(std430, binding = 0) readonly buffer Inputs { float in_data[]; };\n"
        << "layout(std430, binding = 1) writeonly buffer Results { float out_data[]; };\n"
        << "uniform int rows;\n"
        << "float fetch(int i) {\n    return in_data[i];\n}\n"
        << "const int per_input = " << per_input << ";\nconst int per_result = " << per_result << ";\n";
    return out.str();
}

const char* const main_head =
    "void main() {\n"
    "    int row = int(gl_GlobalInvocationID.x);\n"
    "    if (row >= rows) {\n"
    "        return;\n"
    "    }\n"
    "    int base = row * per_input;\n"
    "    int out_base = row * per_result;\n";

/// The same for a fragment shader of WebGL 2: each pixel holds four numbers of a row's results.
std::string webgl_textures(std::size_t per_input, std::size_t per_result) {
    const std::size_t pixels = (per_result + 3) / 4;
    std::ostringstream out;
    out << "uniform highp sampler2D in_data;\n"
        << "uniform int rows;\n"
        << "uniform int width;\n"  // of both textures, in texels
        << "out vec4 pixel;\n"
        << "float fetch(int i) {\n    return texelFetch(in_data, ivec2(i % width, i / width), 0).r;\n}\n"
        << "const int per_input = " << per_input << ";\n"
        << "void main() {\n"
        << "    int texel = int(gl_FragCoord.y) * width + int(gl_FragCoord.x);\n"
        << "    int row = texel / " << pixels << ";\n"
        << "    int first = texel % " << pixels << " * 4;\n"
        << "    pixel = vec4(0.0);\n"
        << "    if (row >= rows) {\n        return;\n    }\n"
        << "    int base = row * per_input;\n"
        << "    const int out_base = 0;\n"
        << "    float out_data[" << pixels * 4 << "];\n";
    return out.str();
}

}  // namespace

std::string expanded(const GlslFolder& glsl, const std::string& file) {
    const std::string name = glsl.one_file ? "airlight.glsl" : file;
    return support::expand_includes(glsl.folder / name, {glsl.folder}).text;
}

std::string function_shader(const Manifest& manifest, const Function& function, const GlslFolder& glsl,
                            const SceneName& scene, bool hooked, Compiled compiled) {
    std::string inputs;
    for (const Member& parameter : function.parameters) {
        inputs += manifest.signature(parameter.type);
    }
    const std::string results = manifest.signature(function.result);

    const bool webgl = compiled == Compiled::webgl;
    std::string text =
        webgl ? "#version 300 es\nprecision highp float;\nprecision highp int;\n" : "#version 430 core\n";
    for (const SceneDefine& define : scene.defines) {
        text += "#define " + define.macro + " " + define.value + "\n";
    }
    if (hooked) {
        text += hooks_glsl;
    }
    text += expanded(glsl, function.file);
    text += webgl ? "\n" + webgl_textures(inputs.size(), results.size())
                  : "\n" + buffers(inputs.size(), results.size()) + main_head;
    std::size_t at = 0;
    std::string arguments;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const Member& parameter = function.parameters[i];
        const std::string argument = "argument_" + std::to_string(i);
        text += "    " + support::glsl_type(manifest, parameter.type) + " " + argument + " = " +
                support::construct(manifest, parameter.type, at) + ";\n";
        arguments += (arguments.empty() ? "" : ", ") + argument;
    }
    text += "    " + support::glsl_type(manifest, function.result) + " result = " + function.glsl + "(" +
            arguments + ");\n";
    at = 0;
    text += support::store(manifest, function.result, "result",
                           compiled == Compiled::pinned ? "precise " : "", at);
    if (webgl) {
        text +=
            "    pixel = vec4(out_data[first], out_data[first + 1], out_data[first + 2], out_data[first + "
            "3]);\n";
    }
    text += "}\n";
    return text;
}

std::string expression_shader(const std::string& expression, bool precise) {
    return "#version 430 core\n" + buffers(2, 1) + main_head +
           "    float x = fetch(base);\n    float y = fetch(base + 1);\n" +
           (precise ? "    precise" : "   ") + " float result = " + expression +
           ";\n    out_data[out_base] = result;\n}\n";
}

std::vector<float> run_shader(const std::string& text, const std::string& name,
                              const std::vector<float>& inputs, std::size_t rows, std::size_t per_result) {
    support::ShaderSource source{GL_COMPUTE_SHADER, text, {name}};
    const support::Program program = support::link_program({source});
    const support::Buffer in = support::create_buffer();
    const support::Buffer out = support::create_buffer();
    const auto bytes = [](std::size_t floats) {
        return static_cast<GLsizeiptr>(std::max<std::size_t>(floats, 1) * sizeof(float));
    };
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in);
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes(inputs.size()), inputs.empty() ? nullptr : inputs.data(),
                 GL_STATIC_DRAW);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out);
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes(rows * per_result), nullptr, GL_DYNAMIC_READ);
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "rows"), static_cast<GLint>(rows));
    glDispatchCompute(static_cast<GLuint>((rows + group_size - 1) / group_size), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<float> results(rows * per_result);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, out);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes(results.size()), results.data());
    support::check_gl(("running the shader of " + name).c_str());
    return results;
}

std::string compile_log(const std::string& text, bool compute) {
    const GLuint shader = glCreateShader(compute ? GL_COMPUTE_SHADER : GL_FRAGMENT_SHADER);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    GLint length = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    glDeleteShader(shader);
    log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
    if (ok != GL_TRUE) {
        return log.empty() ? "the driver refused it without a message" : log;
    }
    return log.find("warning") == std::string::npos ? "" : log;
}

}  // namespace parity
