#include "expression_parts.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {

std::string ExpressionReader::flag_operand() {
    if (tokens_.next_is("(")) {
        tokens_.drop();
        std::string text = "(" + flag_condition() + ")";
        tokens_.drop(")", "a parenthesis");
        return text;
    }
    if (tokens_.next_is("!")) {
        tokens_.drop();
        return "!" + flag_operand();
    }
    const unsigned line = tokens_.line();
    if (tokens_.next_is("Scene") && tokens_.text(1) == "::") {
        const auto flag = program_.flags.find(tokens_.text(2));
        if (!function_.has_scene || flag == program_.flags.end()) {
            tokens_.refuse("DefaultScene has no member '" + tokens_.text(2) + "', or the function no Scene");
        }
        check_visible(flag->second, line);
        function_.flags.insert(flag->first);
        tokens_.drop();
        tokens_.drop();
        tokens_.drop();
        return flag->second.glsl;
    }
    if (tokens_.kind() == TokenKind::literal) {
        check_integer_literal(tokens_.text(), line);
        return drop_text();
    }
    std::size_t length = 1;
    const std::string name = lookup(program_.choices, length);
    if (name.empty()) {
        tokens_.refuse(
            "'" + tokens_.text() +
            "' in if constexpr: the condition is made of Scene:: members, named int constants and literals");
    }
    check_visible(program_.choices.at(name), line);
    drop_qualifiers(length);
    tokens_.drop();
    return program_.choices.at(name).glsl;
}

std::string ExpressionReader::flag_comparison() {
    std::string text = flag_operand();
    if (precedence(tokens_.text()) == 3 || precedence(tokens_.text()) == 4) {
        text += " " + drop_text() + " ";
        text += flag_operand();
    }
    return text;
}

std::string ExpressionReader::flag_condition() {
    std::string text = flag_comparison();
    while (tokens_.next_is("&&") || tokens_.next_is("||")) {
        text += " " + drop_text() + " ";
        text += flag_comparison();
    }
    return text;
}

std::string ExpressionReader::int_bound(const std::string& where, bool parameter_allowed) {
    const std::string text = tokens_.text();
    if (tokens_.kind() == TokenKind::literal) {
        check_integer_literal(text, tokens_.line());
        tokens_.take();
        return text;
    }
    if (text == "Scene" && tokens_.text(1) == "::") {
        const std::string name = tokens_.text(2);
        scene_member();
        return program_.flags.at(name).glsl;
    }
    if (parameter_allowed) {
        for (const Variable& parameter : function_.parameters) {
            if (parameter.name == text && parameter.type == integer_type()) {
                tokens_.take();
                return text;
            }
        }
    }
    tokens_.refuse(
        where + " is a literal" +
        (parameter_allowed ? ", a Scene:: constant or an int parameter" : " or a Scene:: constant") +
        ", not '" + text + "'");
}

void ExpressionReader::array_values(const Type& array) {
    const unsigned line = tokens_.line();
    if (!tokens_.next_is("{")) {
        tokens_.refuse("an array is filled with braces: = {...}");
    }
    tokens_.replace(glsl_type(array) + "(");
    std::size_t count = 0;
    while (!tokens_.next_is("}")) {
        if (count > 0) {
            tokens_.take(",", "a list");
            if (tokens_.next_is("}")) {
                tokens_.refuse("a comma after the last value, which GLSL does not accept");
            }
        }
        expression_of(array.element(), "the array");
        ++count;
    }
    if (std::to_string(count) != array.array) {
        throw Refused(line, "the array holds " + array.array + " values and gets " + std::to_string(count));
    }
    tokens_.replace(")");
}

}  // namespace glslgen
