#include "manifest.hpp"

#include <nlohmann/json.hpp>

#include "declarations.hpp"
#include "layout.hpp"
#include "writer.hpp"

namespace glslgen {
namespace {

using Json = nlohmann::ordered_json;

std::string glsl_file(const std::string& header) {
    return file_of(header.substr(0, header.rfind('.')));
}

Json variables(const std::vector<Variable>& list) {
    Json result = Json::array();
    for (const Variable& variable : list) {
        result.push_back({{"type", manifest_type(variable.type)}, {"name", variable.name}});
    }
    return result;
}

/// A value on one line where it fits, so that a difference shows the entry and not the punctuation.
void write(const Json& value, std::size_t indentation, std::size_t used, std::string& text) {
    const std::string flat = value.dump();
    if (!value.is_structured() || value.empty() || indentation + used + flat.size() <= widest_line) {
        std::string spaced;
        bool in_string = false;
        for (std::size_t i = 0; i < flat.size(); ++i) {
            in_string = in_string != (flat[i] == '"' && (i == 0 || flat[i - 1] != '\\'));
            spaced += flat[i];
            if (!in_string && (flat[i] == ':' || flat[i] == ',')) {
                spaced += ' ';
            }
        }
        text += spaced;
        return;
    }
    const bool object = value.is_object();
    text += object ? "{" : "[";
    const std::string inner(indentation + 2, ' ');
    bool first = true;
    for (const auto& entry : value.items()) {
        text += (first ? "\n" : ",\n") + inner;
        first = false;
        const std::string key = object ? Json(entry.key()).dump() + ": " : "";
        text += key;
        write(entry.value(), indentation + 2, key.size(), text);
    }
    text += "\n" + std::string(indentation, ' ') + (object ? "}" : "]");
}

template <typename Entry>
std::vector<std::string> in_order(const std::vector<std::string>& order, const Entry& chosen) {
    std::vector<std::string> result;
    for (const std::string& name : order) {
        if (chosen.count(name)) {
            result.push_back(name);
        }
    }
    return result;
}

Json constant_entry(const Constant& constant) {
    return {{"name", constant.name},   {"glsl", constant.glsl},     {"type", manifest_type(constant.type)},
            {"value", constant.value}, {"header", constant.header}, {"file", glsl_file(constant.header)}};
}

Json flag_entry(const Flag& flag) {
    Json entry = {{"name", flag.name},
                  {"macro", flag.glsl},
                  {"type", manifest_type(flag.type)},
                  {"default", flag.value}};
    if (!flag.choices.empty()) {
        entry["choices"] = flag.choices;
    }
    return entry;
}

Json hook_entry(const Hook& hook, const Functor& functor) {
    return {{"name", hook.name},
            {"macro", hook.glsl},
            {"parameters", macro_parameters(functor)},
            {"default", functor.body}};
}

Json function_entry(const Function& function, const Program& program) {
    return {{"name", function.name},
            {"glsl", function.glsl},
            {"header", function.header},
            {"file", glsl_file(function.header)},
            {"parameters", variables(function.parameters)},
            {"result", manifest_type(function.result)},
            {"flags", in_order(program.flag_order, function.flags)},
            {"hooks", in_order(program.hook_order, function.all_hooks)},
            {"calls", function.calls}};
}

}  // namespace

std::string manifest(const Program& program) {
    Json constants = Json::array();
    for (const std::string& name : program.constant_order) {
        constants.push_back(constant_entry(program.constants.at(name)));
    }
    Json flags = Json::array();
    for (const std::string& name : program.flag_order) {
        flags.push_back(flag_entry(program.flags.at(name)));
    }
    Json hooks = Json::array();
    for (const std::string& name : program.hook_order) {
        const Hook& hook = program.hooks.at(name);
        hooks.push_back(hook_entry(hook, program.functors.at(hook.functor)));
    }
    Json structs = Json::array();
    for (const std::string& name : program.structure_order) {
        const Structure& structure = program.structures.at(name);
        structs.push_back({{"name", structure.name},
                           {"glsl", structure.glsl},
                           {"file", glsl_file(structure.header)},
                           {"members", variables(structure.members)}});
    }
    Json functions = Json::array();
    for (const std::string& name : program.function_order) {
        functions.push_back(function_entry(program.functions.at(name), program));
    }
    const Json all = {{"constants", constants},
                      {"flags", flags},
                      {"hooks", hooks},
                      {"structs", structs},
                      {"functions", functions}};
    std::string text;
    write(all, 0, 0, text);
    return text + "\n";
}

}  // namespace glslgen
