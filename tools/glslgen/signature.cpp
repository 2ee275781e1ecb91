#include "signature.hpp"

#include <algorithm>

#include "names.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

bool take_prefix(std::string& text, const std::string& prefix) {
    const bool found = text.rfind(prefix, 0) == 0;
    if (found) {
        text.erase(0, prefix.size());
    }
    return found;
}

bool take_suffix(std::string& text, const std::string& suffix) {
    const bool found =
        text.size() >= suffix.size() && text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0;
    if (found) {
        text.erase(text.size() - suffix.size());
    }
    return found;
}

Hook& register_hook(Program& program, const Header& header, const TemplateParameter& parameter,
                    bool has_scene, unsigned line) {
    const auto functor = program.functors.find(parameter.default_type);
    if (functor == program.functors.end()) {
        if (program.refused.count(parameter.default_type)) {
            throw FollowsFromRefusal();
        }
        throw Refused(line,
                      "template parameter '" + parameter.name +
                          "': besides T and Scene = DefaultScene there are hooks only, and a hook's default "
                          "is a functor of airlight");
    }
    if (functor->second.has_scene && !has_scene) {
        throw Refused(line, "the hook " + parameter.name + " is " + functor->first +
                                "<Scene>: the function needs the template parameter Scene before it");
    }
    const auto known = program.hooks.find(parameter.name);
    if (known != program.hooks.end()) {
        if (known->second.functor != functor->first) {
            throw Refused(line, "the hook " + parameter.name + " has the default " + known->second.functor +
                                    " elsewhere: one macro has one meaning");
        }
        return known->second;
    }
    Hook hook;
    hook.name = parameter.name;
    hook.glsl = macro_name(parameter.name);
    hook.header = header.name;
    hook.functor = functor->first;
    program.hook_order.push_back(hook.name);
    return program.hooks[hook.name] = hook;
}

void read_template_parameters(Program& program, const Header& header, const Declaration& declaration,
                              Function& function) {
    const std::vector<TemplateParameter>& parameters = declaration.template_parameters;
    function.is_template = !parameters.empty();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const TemplateParameter& parameter = parameters[i];
        if (!parameter.is_type) {
            throw Refused(declaration.line, "template parameter '" + parameter.name +
                                                "' is no type: make it a member of the scene or a parameter");
        }
        if (i == 0) {
            if (parameter.name != "T" || !parameter.default_type.empty()) {
                throw Refused(declaration.line, "the first template parameter is the scalar, typename T");
            }
        } else if (parameter.name == "Scene") {
            if (parameter.default_type != "DefaultScene" || i != 1) {
                throw Refused(declaration.line, "the scene stands after T: typename Scene = DefaultScene");
            }
            function.has_scene = true;
        } else {
            register_hook(program, header, parameter, function.has_scene, declaration.line);
            function.hooks.push_back(parameter.name);
        }
    }
}

bool is_hook_type(const Function& function, const std::string& spelling) {
    return std::any_of(function.hooks.begin(), function.hooks.end(), [&](const std::string& hook) {
        return spelling.find(hook) != std::string::npos && spelling.find('<') == std::string::npos;
    });
}

void read_hook_parameter(const ParameterDeclaration& parameter, Function& function) {
    const std::size_t position = function.hook_names.size();
    const std::string wanted = position < function.hooks.size() ? function.hooks[position] : "";
    if (parameter.type != "const " + wanted + " &" || !parameter.has_default) {
        throw Refused(parameter.line, "a hook is passed as const " + wanted + "& " + parameter.name + " = " +
                                          wanted + "{}, hooks in the order of the template parameters");
    }
    function.hook_names.push_back(parameter.name);
}

}  // namespace

Type spelled_type(const Program& program, const std::string& spelling, const std::string& scope,
                  const std::string& whose, unsigned line) {
    std::string text = spelling;
    const auto refuse = [&](const std::string& reason) -> void {
        throw Refused(line, whose + " is " + spelling + ": " + reason);
    };
    if (text.find('*') != std::string::npos) {
        refuse("GLSL has no pointers");
    }
    const bool is_const = take_prefix(text, "const ");
    if (take_suffix(text, " &&") || (take_suffix(text, " &") && !is_const)) {
        refuse("no out-parameters and no references to what is not const; return a struct");
    }
    take_prefix(text, "airlight::");
    if (text == "T") {
        return scalar_type();
    }
    if (text == "int") {
        return integer_type();
    }
    if (text == "bool") {
        return boolean_type();
    }
    if (take_suffix(text, "<T>")) {
        if (text == "vec2" || text == "vec3" || text == "vec4") {
            return vector_type(text[3] - '0');
        }
        for (const std::string& name : {scope + text, text}) {
            if (program.structures.count(name)) {
                return structure_type(name);
            }
            if (program.refused.count(name)) {
                throw FollowsFromRefusal();
            }
        }
    }
    refuse("the types are T, int, bool, vec2<T> to vec4<T> and structs of airlight that stand before");
    return {};
}

void read_signature(Program& program, const Header& header, const Declaration& declaration,
                    Function& function) {
    if (declaration.name.rfind("operator", 0) == 0) {
        throw Refused(declaration.line, "an operator: write a function with a name");
    }
    if (!declaration.body_begin) {
        throw Refused(declaration.line,
                      "'" + declaration.name + "' has no body here: define it before its use");
    }
    check_identifier(glsl_name(function.name), declaration.line);
    read_template_parameters(program, header, declaration, function);
    if (declaration.result_type == "void") {
        throw Refused(declaration.line, "'" + declaration.name + "' returns nothing, so it can do nothing");
    }
    for (const ParameterDeclaration& parameter : declaration.parameters) {
        if (is_hook_type(function, parameter.type)) {
            read_hook_parameter(parameter, function);
            continue;
        }
        if (!function.hook_names.empty()) {
            throw Refused(parameter.line,
                          "parameter '" + parameter.name + "' stands after a hook: hooks come last");
        }
        if (parameter.name.empty()) {
            throw Refused(parameter.line, "a parameter without a name");
        }
        if (parameter.has_default) {
            throw Refused(parameter.line,
                          "parameter '" + parameter.name + "' has a default: only hooks have one");
        }
        const Type type = spelled_type(program, parameter.type, declaration.scope,
                                       "parameter '" + parameter.name + "'", parameter.line);
        function.parameters.push_back({parameter.name, type});
    }
    if (function.hook_names.size() != function.hooks.size()) {
        throw Refused(declaration.line, "the hook " + function.hooks[function.hook_names.size()] +
                                            " is a template parameter that no parameter carries");
    }
    function.result =
        spelled_type(program, declaration.result_type, declaration.scope, "the result", declaration.line);
    for (const std::string& hook : function.hooks) {
        const Functor& functor = program.functors.at(program.hooks.at(hook).functor);
        function.all_hooks.insert(hook);
        function.flags.insert(functor.flags.begin(), functor.flags.end());
    }
}

std::vector<Line> signature_lines(const Function& function) {
    std::vector<Line> lines;
    std::string line = glsl_type(function.result) + " " + function.glsl + "(";
    const std::string indentation(line.size(), ' ');
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const bool last = i + 1 == function.parameters.size();
        const std::string text = glsl_type(function.parameters[i].type) + " " + function.parameters[i].name;
        const std::size_t room = widest_line - (last ? 3 : 1);  // for ") {" or ","
        if (i > 0 && line.size() + 1 + text.size() > room) {
            lines.push_back({line, "", 0});
            line = indentation + text;
        } else {
            line += (i > 0 ? " " : "") + text;
        }
        line += last ? "" : ",";
    }
    lines.push_back({line + ")", "", 0});
    return lines;
}

}  // namespace glslgen
