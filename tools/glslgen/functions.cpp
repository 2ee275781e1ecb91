#include <algorithm>

#include "body.hpp"
#include "declarations.hpp"
#include "expression.hpp"
#include "names.hpp"
#include "refusal.hpp"
#include "signature.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

/// Registers the function while its body is read, so that a call of itself is seen as one; takes it back
/// when the body is refused.
class Registration {
  public:
    Registration(Program& program, const Function& function) : program_(program), name_(function.name) {
        if (program.functions.count(name_)) {
            program.refused.insert(name_);
        }
        program.functions[name_] = function;
    }
    ~Registration() {
        if (!done_) {
            program_.functions.erase(name_);
        }
    }
    Registration(const Registration&) = delete;
    Registration& operator=(const Registration&) = delete;
    void finish(const Function& function) {
        program_.functions[name_] = function;
        program_.function_order.push_back(name_);
        done_ = true;
    }

  private:
    Program& program_;
    std::string name_;
    bool done_ = false;
};

/// A structure is no parameter of the macro: its text sees the caller's variable of that name.
bool seen_by_macro(const Variable& parameter) {
    return parameter.type.is(Type::Kind::structure);
}

/// `{ return expression; }` of a functor, as the text of a macro whose parameters may be any expression.
std::string macro_body(const Site& site, const MemberDeclaration& call, Function& function) {
    TokenStream tokens(site.header, site.edits, call.body_begin, call.body_end);
    Locals locals;
    locals.open();
    for (const Variable& parameter : function.parameters) {
        locals.declare(parameter.name, {parameter.type, true, call.line});
    }
    ExpressionReader expressions(site.program, tokens, locals, function, site.declaration.scope);
    tokens.drop("{", "a hook's default");
    if (!tokens.next_is("return")) {
        tokens.refuse("a hook's default is one return statement");
    }
    tokens.drop();
    const std::size_t first = tokens.index();
    expressions.expression_of(function.result, "the result");
    const std::size_t last = tokens.drop(";", "a return");
    if (!tokens.next_is("}")) {
        tokens.refuse("a hook's default is one return statement");
    }
    std::size_t kept = 0;
    for (std::size_t i = first; i < last; ++i) {
        const std::string& text = site.header.tokens[i].text;
        const bool is_parameter = site.edits[i].kind == Edit::Kind::keep &&
                                  site.header.tokens[i - 1].text != "." &&
                                  std::any_of(function.parameters.begin(), function.parameters.end(),
                                              [&](const Variable& parameter) {
                                                  return parameter.name == text && !seen_by_macro(parameter);
                                              });
        if (is_parameter) {
            site.edits[i].kind = Edit::Kind::replace;
            site.edits[i].text = "(" + text + ")";
        }
        kept += site.edits[i].kind != Edit::Kind::drop ? 1 : 0;
    }
    const std::string text = joined_code(lay_out(site.header, site.edits, first, last));
    return kept > 1 ? "(" + text + ")" : text;
}

}  // namespace

std::vector<Line> read_function(const Site& site) {
    const Declaration& declaration = site.declaration;
    const std::vector<std::string> doc = comment_texts(site.comments.doc);
    Function function;
    static_cast<Named&>(function) = named(site);
    if (site.program.functions.count(function.name)) {
        throw Refused(declaration.line, "'" + function.name + "' is an overload: one name has one signature");
    }
    check_words(site.header.tokens, declaration.begin, declaration.end, declaration.body_begin);
    read_signature(site.program, site.header, declaration, function);
    if (declaration.scope.empty()) {
        check_function_docstring(doc, function.name, declaration.line);
    } else if (doc.empty()) {
        throw Refused(declaration.line, "'" + function.name + "' has no docstring: one sentence");
    }
    Registration registration(site.program, function);
    read_body(site.program, site.header, site.edits, function, declaration.scope, declaration.body_begin,
              declaration.body_end);
    function.complete = true;

    std::vector<Line> lines = signature_lines(function);
    const TokenRange range = range_of(site);
    const std::vector<Line> body =
        lay_out(site.header, site.edits, first_token_at(site.header, declaration.body_begin), range.last);
    // The body's first line is its brace, which belongs on the last line of the signature.
    lines.back().code += " " + body.front().code.substr(body.front().code.find('{'));
    lines.back().comment = body.front().comment;
    lines.insert(lines.end(), body.begin() + 1, body.end());
    registration.finish(function);
    return lines;
}

void read_functor(const Site& site) {
    const Declaration& declaration = site.declaration;
    if (site.comments.doc.empty()) {
        throw Refused(declaration.line, "'" + declaration.name + "' has no docstring: one sentence");
    }
    if (declaration.members.size() != 1) {
        throw Refused(declaration.line, "a hook's functor has one member, operator()");
    }
    const std::vector<TemplateParameter>& scene = declaration.template_parameters;
    if (scene.size() > 1 || (scene.size() == 1 && scene.front().name != "Scene")) {
        throw Refused(declaration.line, "a hook's functor is a template of nothing or of the Scene");
    }
    const MemberDeclaration& call = declaration.members.front();
    check_words(site.header.tokens, call.body_begin, call.body_end);
    Functor functor;
    static_cast<Named&>(functor) = named(site);
    functor.result = spelled_type(site.program, call.result_type, declaration.scope, "the result", call.line);
    Function function;
    static_cast<Named&>(function) = named(site);
    function.complete = true;
    function.has_scene = functor.has_scene = scene.size() == 1;
    function.result = functor.result;
    for (const ParameterDeclaration& parameter : call.parameters) {
        if (parameter.name.empty()) {
            throw Refused(
                parameter.line,
                "a parameter of a hook without a name: the macro shows it, so write [[maybe_unused]]");
        }
        check_identifier(parameter.name, parameter.line);
        functor.parameters.push_back(
            {parameter.name, spelled_type(site.program, parameter.type, declaration.scope,
                                          "parameter '" + parameter.name + "'", parameter.line)});
    }
    function.parameters = functor.parameters;
    functor.body = macro_body(site, call, function);
    functor.flags = function.flags;
    functor.calls = function.calls;
    functor.comment = comment_lines(site.comments.doc);
    site.program.functors[functor.name] = functor;
}

std::vector<std::string> macro_parameters(const Functor& functor) {
    std::vector<std::string> names;
    for (const Variable& parameter : functor.parameters) {
        if (!seen_by_macro(parameter)) {
            names.push_back(parameter.name);
        }
    }
    return names;
}

std::vector<Line> hook_lines(const Program& program, const std::string& hook) {
    const Hook& found = program.hooks.at(hook);
    const Functor& functor = program.functors.at(found.functor);
    std::string parameters;
    for (const std::string& parameter : macro_parameters(functor)) {
        parameters += (parameters.empty() ? "" : ", ") + parameter;
    }
    std::vector<Line> lines = functor.comment;
    lines.push_back(
        {"", "// In GLSL, define the macro before this line, as the call of a function of your own.", 0});
    lines.push_back({"#ifndef " + found.glsl, "", 0});
    lines.push_back({"#define " + found.glsl + "(" + parameters + ") " + functor.body, "", 0});
    lines.push_back({"#endif", "", 0});
    return lines;
}

}  // namespace glslgen
