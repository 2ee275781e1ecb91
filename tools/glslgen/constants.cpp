#include <algorithm>

#include "declarations.hpp"
#include "expression.hpp"
#include "names.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

void check_has_comment(const Site& site) {
    if (site.comments.doc.empty() && site.comments.trailing.empty() && !site.comments.in_group) {
        throw Refused(site.declaration.line,
                      "'" + site.declaration.name + "' has no comment: what it is, unit, source");
    }
}

/// Drops both words and returns where the second stands.
std::size_t pass_inline_constexpr(TokenStream& tokens) {
    std::size_t last = 0;
    for (const char* word : {"inline", "constexpr"}) {
        if (!tokens.next_is(word)) {
            tokens.refuse("a constant begins with inline constexpr, not with '" + tokens.text() + "'");
        }
        last = tokens.drop();
    }
    return last;
}

/// The number or the named int that a choice or a flag is set to.
std::string int_value(const Program& program, const std::string& scope, TokenStream& tokens) {
    if (tokens.kind() == TokenKind::literal) {
        check_integer_literal(tokens.text(), tokens.line());
        const std::string value = tokens.text();
        tokens.drop();
        return value;
    }
    for (const std::string& name : {scope + tokens.text(), tokens.text()}) {
        const auto choice = program.choices.find(name);
        if (choice != program.choices.end()) {
            tokens.drop();
            return choice->second.glsl;
        }
    }
    tokens.refuse("'" + tokens.text() + "' is neither an int literal nor a named int of this namespace");
}

/// Macros of the choices that a flag may be set to: the named ints that begin like its default.
std::vector<std::string> choices_like(const Program& program, const std::string& default_name) {
    const std::string stem = default_name.substr(0, default_name.find('_') + 1);
    std::vector<std::pair<int, std::string>> found;
    for (const auto& [name, choice] : program.choices) {
        if (name.rfind(stem, 0) == 0) {
            found.emplace_back(std::atoi(choice.value.c_str()), choice.glsl);
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> macros;
    for (const auto& entry : found) {
        macros.push_back(entry.second);
    }
    return macros;
}

/// " (0 or 1)", " (A, B or C)": what a shader may define the macro as.
std::string allowed_values(const Flag& flag) {
    std::vector<std::string> values = flag.choices;
    if (flag.type == boolean_type()) {
        values = {"0", "1"};
    }
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == values.size() ? " or " : ", ") + values[i];
    }
    return text.empty() ? "" : " (" + text + ")";
}

}  // namespace

std::vector<Line> read_constant(const Site& site) {
    check_has_comment(site);
    check_words(site.header.tokens, site.declaration.begin, site.declaration.end);
    TokenStream tokens = stream_of(site);
    Locals locals;
    Function no_function;
    ExpressionReader expressions(site.program, tokens, locals, no_function, site.declaration.scope);
    Constant constant;
    static_cast<Named&>(constant) = named(site);

    drop_scalar_template(tokens);
    const std::size_t constexpr_at = pass_inline_constexpr(tokens);
    tokens.edit(constexpr_at).kind = Edit::Kind::replace;
    tokens.edit(constexpr_at).text = "const";
    tokens.edit(constexpr_at).statement = true;
    constant.type = expressions.type();
    check_identifier(constant.name, tokens.line());
    tokens.replace(constant.glsl);
    if (tokens.next_is("[")) {
        tokens.take();
        constant.type = constant.type.array_of(expressions.int_bound("the size of a constant array", false));
        tokens.take("]", "an array");
    }
    const std::size_t equals = tokens.take("=", "a constant");
    if (constant.type.is_array()) {
        expressions.array_values(constant.type);
    } else {
        expressions.expression_of(constant.type, "'" + constant.name + "'");
    }
    tokens.take(";", "a constant");

    const TokenRange range = range_of(site);
    constant.value = joined_code(lay_out(site.header, site.edits, equals + 1, range.last - 1));
    site.program.constants[constant.name] = constant;
    site.program.constant_order.push_back(constant.name);
    return lay_out(site.header, site.edits, range.first, range.last);
}

std::vector<Line> read_choice(const Site& site) {
    check_has_comment(site);
    check_words(site.header.tokens, site.declaration.begin, site.declaration.end);
    TokenStream tokens = stream_of(site);
    pass_inline_constexpr(tokens);
    if (!tokens.next_is("int")) {
        tokens.refuse("'" + tokens.text() + "': a constant that is no int is a template over T");
    }
    tokens.drop();
    tokens.drop();
    tokens.drop("=", "a named int");
    Choice choice;
    static_cast<Named&>(choice) = named(site);
    choice.glsl = macro_name(choice.name);
    choice.value = int_value(site.program, site.declaration.scope, tokens);
    tokens.drop(";", "a named int");
    site.program.choices[choice.name] = choice;
    return {{"#define " + choice.glsl + " " + choice.value, "", 0}};
}

std::vector<Line> read_scene(const Site& site) {
    if (site.comments.doc.empty()) {
        throw Refused(site.declaration.line,
                      "'" + site.declaration.name + "' has no docstring: one sentence");
    }
    TokenStream tokens = stream_of(site);
    for (const char* word : {"struct", "DefaultScene", "{"}) {
        tokens.drop(word, "the scene, struct DefaultScene {...};");
    }
    std::vector<Line> lines;
    while (!tokens.next_is("}")) {
        const std::size_t before = tokens.index();
        for (const char* word : {"static", "constexpr"}) {
            if (!tokens.next_is(word)) {
                tokens.refuse("'" + tokens.text() +
                              "': a member of the scene is static constexpr bool or int");
            }
            tokens.drop();
        }
        Flag flag;
        flag.type = tokens.next_is("bool") ? boolean_type() : integer_type();
        if (!tokens.next_is("bool") && !tokens.next_is("int")) {
            tokens.refuse("'" + tokens.text() + "': a member of the scene is static constexpr bool or int");
        }
        tokens.drop();
        flag.name = tokens.text();
        flag.header = site.header.name;
        flag.glsl = macro_name(flag.name);
        const unsigned line = tokens.line();
        check_identifier(flag.name, line);
        tokens.drop();
        tokens.drop("=", "a member of the scene");
        if (flag.type == boolean_type()) {
            if (!tokens.next_is("true") && !tokens.next_is("false")) {
                tokens.refuse("'" + tokens.text() + "': a bool of the scene is true or false");
            }
            flag.value = tokens.next_is("true") ? "1" : "0";
            tokens.drop();
        } else {
            const std::string default_name = tokens.text();
            flag.value = int_value(site.program, site.declaration.scope, tokens);
            if (site.program.choices.count(default_name)) {
                flag.choices = choices_like(site.program, default_name);
            }
        }
        const std::size_t semicolon = tokens.drop(";", "a member of the scene");

        std::vector<Line> comment = comment_lines(member_comments(site.header, before, semicolon));
        if (comment.empty()) {
            throw Refused(line, "'" + flag.name + "' has no comment");
        }
        const std::string allowed = allowed_values(flag);
        if (comment.back().comment.size() + allowed.size() <= widest_line) {
            comment.back().comment += allowed;
        } else {
            comment.push_back({"", "//" + allowed, 0});
        }
        lines.insert(lines.end(), comment.begin(), comment.end());
        lines.push_back({"#ifndef " + flag.glsl, "", 0});
        lines.push_back({"#define " + flag.glsl + " " + flag.value, "", 0});
        lines.push_back({"#endif", "", 0});
        site.program.flags[flag.name] = flag;
        site.program.flag_order.push_back(flag.name);
    }
    return lines;
}

}  // namespace glslgen
