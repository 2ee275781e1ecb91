#include "shaders.hpp"

#include <set>
#include <sstream>
#include <string>

#include "support/error.hpp"
#include "support/glsl_source.hpp"
#include "support/glsl_values.hpp"

namespace shader_cost {
namespace {

/// Whether a value is of the scene and not of the ray.
bool is_uniform(const std::string& type) {
    return type == "Atmosphere";
}

/// Functions that find no light without a hook that says where it is dark.
const std::set<std::string> functions_in_shadow = {"light_lost_in_shadow"};

/// Defines the hooks that a texture may stand behind: a table, by its coordinates, and a shadow map.
std::string texture_hooks(const support::Manifest& manifest, const support::Function& function) {
    std::string out;
    for (const std::string& name : function.hooks) {
        const support::Hook& hook = manifest.hook(name);
        const bool table = hook.parameters == std::vector<std::string>{"uv"};
        const bool shadow_map = hook.parameters == std::vector<std::string>{"position"} &&
                                functions_in_shadow.count(function.name) != 0;
        if (!table && !shadow_map) {
            continue;
        }
        if (out.empty()) {
            out = "layout(binding = " + std::to_string(binding::table) + ") uniform sampler2D table;\n";
        }
        if (shadow_map) {
            out += "#define " + hook.macro +
                   "(position) step((position).z, textureLod(table, (position).xy, 0.0).r)\n";
            continue;
        }
        const bool of_two = hook.default_value.find("vec2") != std::string::npos;
        out += "#define " + hook.macro + "(uv) textureLod(table, uv, 0.0)." + (of_two ? "rg" : "rgb") + "\n";
    }
    return out;
}

std::string atmosphere_block(const std::string& type) {
    return "layout(std140, binding = " + std::to_string(binding::atmosphere) + ") uniform Scene { " + type +
           " atmosphere; };\n";
}

/// The deferred renderer's declarations in the form that Vulkan asks for.
std::string bound_for_vulkan(std::string text, const std::string& atmosphere_type) {
    const auto replace = [&text](const std::string& declaration, const std::string& bound) {
        const std::size_t at = text.find(declaration);
        if (at == std::string::npos) {
            throw support::Error("examples/deferred/shaders/tables.glsl has no '" + declaration +
                                 "' any more; write bench/shader_cost/shaders.cpp anew");
        }
        text.replace(at, declaration.size(), bound);
    };
    replace("layout(std140) uniform AtmosphereBlock {\n    " + atmosphere_type + " atmosphere;\n};\n",
            atmosphere_block(atmosphere_type));
    for (std::uint32_t i = 0; i < binding::tables; ++i) {
        const std::string sampler = "uniform sampler3D table_" + std::to_string(i) + ";";
        replace(sampler, "layout(binding = " + std::to_string(binding::table + i) + ") " + sampler);
    }
    replace("uniform ivec4 scattering_size;", "layout(std140, binding = " + std::to_string(binding::sizes) +
                                                  ") uniform Sizes { ivec4 scattering_size; };");
    return text;
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
        out << atmosphere_block(support::glsl_type(manifest, "Atmosphere"));
    }
    out << "float fetch(int i) {\n    return in_data[i];\n}\n"
        << "void main() {\n"
        << "    int base = int(gl_GlobalInvocationID.x) * " << per_input << ";\n"
        << "    int out_base = int(gl_GlobalInvocationID.x) * " << per_result << ";\n";
    return out.str();
}

}  // namespace

std::string function_shader(const Library& library, const support::Function& function,
                            const std::vector<bench::FlagValue>& flags, const std::vector<int>& counts,
                            const std::string& tables) {
    const support::Manifest& manifest = library.manifest;
    std::string text = "#version 450 core\n";
    for (const bench::FlagValue& flag : flags) {
        text += "#define " + flag.macro + " " + flag.value + "\n";
    }
    std::string includes = "#include \"" + function.file + "\"\n";
    if (tables.empty()) {
        text += texture_hooks(manifest, function);
    } else {
        text += "#define TABLES " + tables + "\n";
        includes = "#include \"airlight/atmosphere.glsl\"\n#include \"tables.glsl\"\n" + includes;
    }
    const std::string included = support::expand_includes(includes, function.name, library.folders).text;
    const std::string atmosphere_type = support::glsl_type(manifest, "Atmosphere");
    text += tables.empty() ? included : bound_for_vulkan(included, atmosphere_type);

    std::string arguments;
    std::size_t at = 0;
    std::size_t count = 0;
    bool atmosphere = false;
    for (const support::Member& parameter : function.parameters) {
        std::string argument;
        if (is_uniform(parameter.type)) {
            atmosphere = true;
            argument = "atmosphere";
        } else if (parameter.type == "int") {
            argument = count < counts.size() ? std::to_string(counts[count++]) : "1";
        } else {
            argument = support::construct(manifest, parameter.type, at);
        }
        arguments += (arguments.empty() ? "" : ", ") + argument;
    }
    text += resources(manifest, atmosphere && tables.empty(), at, manifest.signature(function.result).size());
    text += "    " + support::glsl_type(manifest, function.result) + " result = " + function.glsl + "(" +
            arguments + ");\n";
    at = 0;
    return text + support::store(manifest, function.result, "result", "", at) + "}\n";
}

}  // namespace shader_cost
