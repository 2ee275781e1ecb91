#include "expression_parts.hpp"
#include "refusal.hpp"

namespace glslgen {

const std::string* ExpressionReader::hook_of(const std::string& parameter) const {
    for (std::size_t i = 0; i < function_.hook_names.size(); ++i) {
        if (function_.hook_names[i] == parameter) {
            return &function_.hooks[i];
        }
    }
    return nullptr;
}

void ExpressionReader::drop_structure_of_hook(const std::string& hook, const Variable& parameter) {
    const Local* local = tokens_.kind() == TokenKind::identifier ? locals_.find(tokens_.text()) : nullptr;
    const bool whole = tokens_.text(1) == "," || tokens_.text(1) == ")";
    if (!local || !whole || local->type != parameter.type || !tokens_.next_is(parameter.name)) {
        tokens_.refuse("the hook " + hook + " takes the caller's " + cpp_type(parameter.type) + " " +
                       parameter.name + ": its macro sees no other");
    }
    tokens_.drop();
}

void ExpressionReader::note_call(const std::string& name) {
    bool known = false;
    for (const std::string& call : function_.calls) {
        known = known || call == name;
    }
    if (!known) {
        function_.calls.push_back(name);
    }
}

Value ExpressionReader::hook_call(const std::string& hook) {
    const unsigned line = tokens_.line();
    const Hook& called = program_.hooks.at(hook);
    const Functor& functor = program_.functors.at(called.functor);
    if (tokens_.text(1) != "(") {
        tokens_.refuse("the hook '" + tokens_.text() +
                       "' is neither called nor passed on as its callee's hook");
    }
    tokens_.replace(called.glsl);
    tokens_.take("(", "a hook's call");
    const auto refuse = [&]() -> void {
        throw Refused(line,
                      "the hook " + hook + " is called otherwise than " + functor.name + "::operator()");
    };
    for (std::size_t i = 0; i < functor.parameters.size(); ++i) {
        const Variable& parameter = functor.parameters[i];
        const bool last = i + 1 == functor.parameters.size();
        if (parameter.type.is(Type::Kind::structure)) {
            drop_structure_of_hook(hook, parameter);
            if (!last && !tokens_.drop_if(",")) {
                refuse();
            }
            continue;
        }
        if (tokens_.next_is(")") || expression().type != parameter.type || (!last && !tokens_.take_if(","))) {
            refuse();
        }
    }
    if (!tokens_.take_if(")")) {
        refuse();
    }
    for (const std::string& call : functor.calls) {
        note_call(call);
    }
    return value_of(functor.result);
}

void ExpressionReader::template_arguments(const Function& callee) {
    std::vector<std::string> given;
    if (callee.is_template && tokens_.next_is("<")) {
        tokens_.drop();
        while (!tokens_.next_is(">")) {
            if (!given.empty()) {
                tokens_.drop(",", "a template argument list");
            }
            given.push_back(drop_text());
        }
        tokens_.drop();
    }
    std::vector<std::string> wanted = {"T"};
    if (callee.has_scene) {
        wanted.push_back("Scene");
        if (given.size() < 2) {
            tokens_.refuse("'" + callee.name + "' is called without the caller's Scene: write " +
                           callee.name +
                           "<T, Scene>(...), or C++ takes DefaultScene where GLSL takes the shader's macros");
        }
    }
    wanted.insert(wanted.end(), callee.hooks.begin(), callee.hooks.end());
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (i >= wanted.size() || given[i] != wanted[i]) {
            tokens_.refuse("template argument '" + given[i] + "' of '" + callee.name + "': pass on " +
                           (i < wanted.size() ? wanted[i] : std::string("nothing there")));
        }
    }
    if (callee.has_scene && !function_.has_scene) {
        tokens_.refuse("'" + function_.name + "' calls '" + callee.name +
                       "', so it needs the template parameter Scene too");
    }
}

void ExpressionReader::drop_hook_arguments(const Function& callee) {
    for (std::size_t i = 0; i < callee.hooks.size(); ++i) {
        const bool after_others = !callee.parameters.empty() || i > 0;
        const std::string argument = tokens_.text(after_others ? 1 : 0);
        const std::string* hook = hook_of(argument);
        if (tokens_.next_is(")") || !hook || *hook != callee.hooks[i]) {
            tokens_.refuse(
                "'" + callee.name + "' is called without the hook " + callee.hooks[i] +
                ": pass the caller's own on, or C++ takes the default where GLSL takes the shader's macro");
        }
        if (after_others) {
            tokens_.drop();
        }
        tokens_.drop();
    }
}

Value ExpressionReader::own_call(const std::string& name) {
    const unsigned line = tokens_.line();
    const Function& callee = program_.functions.at(name);
    if (!callee.complete) {
        tokens_.refuse("'" + name + "' calls itself: GLSL has no recursion");
    }
    check_visible(callee, line);
    std::size_t length = 1;
    written_name(length);
    drop_qualifiers(length);
    tokens_.replace(callee.glsl);
    template_arguments(callee);
    tokens_.take("(", "a call");
    for (std::size_t i = 0; i < callee.parameters.size(); ++i) {
        if (tokens_.next_is(")") || (i > 0 && !tokens_.next_is(","))) {
            throw Refused(line,
                          "'" + name + "' takes " + std::to_string(callee.parameters.size()) + " arguments");
        }
        if (i > 0) {
            tokens_.take();
        }
        expression_of(callee.parameters[i].type,
                      "parameter '" + callee.parameters[i].name + "' of '" + name + "'");
    }
    drop_hook_arguments(callee);
    if (!tokens_.next_is(")")) {
        throw Refused(line,
                      "'" + name + "' takes " + std::to_string(callee.parameters.size()) + " arguments");
    }
    tokens_.take();
    note_call(name);
    function_.flags.insert(callee.flags.begin(), callee.flags.end());
    function_.all_hooks.insert(callee.all_hooks.begin(), callee.all_hooks.end());
    return value_of(callee.result);
}

}  // namespace glslgen
