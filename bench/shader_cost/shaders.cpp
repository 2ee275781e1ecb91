#include "shaders.hpp"

#include <sstream>

#include "support/glsl_source.hpp"
#include "support/glsl_values.hpp"

namespace shader_cost {
namespace {

/// Whether a value is of the scene and not of the ray.
bool is_uniform(const std::string& type) {
    return type == "Atmosphere";
}

/// Defines the hooks that a table may stand behind: those that take texture coordinates.
std::string tables(const support::Manifest& manifest, const support::Function& function) {
    std::string out;
    for (const std::string& name : function.hooks) {
        const support::Hook& hook = manifest.hook(name);
        if (hook.parameters != std::vector<std::string>{"uv"}) {
            continue;
        }
        if (out.empty()) {
            out = "layout(binding = " + std::to_string(binding::table) + ") uniform sampler2D table;\n";
        }
        const bool of_two = hook.default_value.find("vec2") != std::string::npos;
        out += "#define " + hook.macro + "(uv) textureLod(table, uv, 0.0)." + (of_two ? "rg" : "rgb") + "\n";
    }
    return out;
}

std::string resources(const support::Manifest& manifest, bool atmosphere, std::size_t per_input,
                      std::size_t per_result) {
    std::ostringstream out;
    out << "layout(local_size_x = 64) in;\n"
        << "layout(std430, binding = " << binding::inputs
        << ") readonly buffer Inputs { float in_data[]; };\n"
        << "layout(std430, binding = " << binding::results
        << ") writeonly buffer Results { float out_data[]; };\n";
    if (atmosphere) {
        out << "layout(std140, binding = " << binding::atmosphere << ") uniform Scene { "
            << support::glsl_type(manifest, "Atmosphere") << " scene_atmosphere; };\n";
    }
    out << "float fetch(int i) {\n    return in_data[i];\n}\n"
        << "void main() {\n"
        << "    int base = int(gl_GlobalInvocationID.x) * " << per_input << ";\n"
        << "    int out_base = int(gl_GlobalInvocationID.x) * " << per_result << ";\n";
    return out.str();
}

}  // namespace

std::string function_shader(const Library& library, const support::Function& function,
                            const std::vector<bench::FlagValue>& flags, const std::vector<int>& counts) {
    const support::Manifest& manifest = library.manifest;
    std::string text = "#version 450 core\n";
    for (const bench::FlagValue& flag : flags) {
        text += "#define " + flag.macro + " " + flag.value + "\n";
    }
    text += tables(manifest, function);
    text +=
        support::expand_includes("#include \"" + function.file + "\"\n", function.name, library.folders).text;

    std::string arguments;
    std::size_t at = 0;
    std::size_t count = 0;
    bool atmosphere = false;
    for (const support::Member& parameter : function.parameters) {
        std::string argument;
        if (is_uniform(parameter.type)) {
            atmosphere = true;
            argument = "scene_atmosphere";
        } else if (parameter.type == "int") {
            argument = count < counts.size() ? std::to_string(counts[count++]) : "1";
        } else {
            argument = support::construct(manifest, parameter.type, at);
        }
        arguments += (arguments.empty() ? "" : ", ") + argument;
    }
    text += resources(manifest, atmosphere, at, manifest.signature(function.result).size());
    text += "    " + support::glsl_type(manifest, function.result) + " result = " + function.glsl + "(" +
            arguments + ");\n";
    at = 0;
    return text + support::store(manifest, function.result, "result", "", at) + "}\n";
}

}  // namespace shader_cost
