#include <cmath>
#include <cstdlib>

#include "builtins.hpp"
#include "expression_parts.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {

Value ExpressionReader::primary() {
    const std::string& text = tokens_.text();
    if (text == "(") {
        return parenthesised();
    }
    if (text == "true" || text == "false") {
        tokens_.take();
        return value_of(boolean_type());
    }
    if (tokens_.kind() == TokenKind::literal) {
        return literal();
    }
    if (text == "[") {
        tokens_.refuse("a lambda: write a function of its own");
    }
    if (text == "{") {
        tokens_.refuse("braces without a type: write the struct's name before them, Name<T>{...}");
    }
    if (text == "T") {
        return scalar_conversion();
    }
    if (is_vector_name(text)) {
        return vector_constructor();
    }
    if (text == "Scene" && tokens_.text(1) == "::") {
        return scene_member();
    }
    if (text == "glm" && tokens_.text(1) == "::") {
        return builtin_call();
    }
    if (text == "std" && tokens_.text(2) == "numeric_limits") {
        return infinity();
    }
    return named();
}

Value ExpressionReader::parenthesised() {
    tokens_.take();
    if (at_type()) {
        tokens_.refuse("a cast: convert an int with T(...)");
    }
    Value value = expression();
    tokens_.take(")", "a parenthesis");
    value.writable = false;
    return value;
}

Value ExpressionReader::literal() {
    const std::string text = tokens_.text();
    if (is_fractional(text)) {
        scalar_literal(text, tokens_.line());
        tokens_.refuse("bare literal " + text + ": write T(" + text + ")");
    }
    check_integer_literal(text, tokens_.line());
    tokens_.take();
    Value value = value_of(integer_type());
    value.bare_literal = true;
    return value;
}

Value ExpressionReader::scalar_conversion() {
    const unsigned line = tokens_.line();
    if (tokens_.text(1) == "{") {
        tokens_.refuse("T{...}: write T(...)");
    }
    const bool negative = tokens_.text(2) == "-";
    const std::size_t literal_at = negative ? 3 : 2;
    if (tokens_.kind(literal_at) == TokenKind::literal && tokens_.text(literal_at + 1) == ")") {
        drop_text();
        tokens_.drop("(", "T(...)");
        if (negative) {
            tokens_.drop();
        }
        const std::string number = (negative ? "-" : "") + scalar_literal(tokens_.text(), line);
        tokens_.drop();
        tokens_.replace(number);
        Value value = value_of(scalar_type());
        value.number = std::strtod(number.c_str(), nullptr);
        return value;
    }
    tokens_.replace("float");
    tokens_.take("(", "T(...)");
    const Value value = expression();
    tokens_.take(")", "T(...)");
    if (value.type != integer_type()) {
        throw Refused(line, "T(...) around " + cpp_type(value.type) + ": it converts literals and int only");
    }
    return value_of(scalar_type());
}

std::vector<Value> ExpressionReader::arguments(const std::string& open, const std::string& close) {
    std::vector<Value> values;
    tokens_.take(open, "a call");
    while (!tokens_.next_is(close)) {
        if (!values.empty()) {
            tokens_.take(",", "a list");
        }
        values.push_back(expression());
    }
    tokens_.take();
    return values;
}

Value ExpressionReader::vector_constructor() {
    const unsigned line = tokens_.line();
    const Type result = type();
    if (tokens_.next_is("{")) {
        tokens_.refuse("a vector is built with parentheses: " + cpp_type(result) + "(...)");
    }
    const std::vector<Value> values = arguments("(", ")");
    int components = 0;
    bool all_one = !values.empty();
    for (const Value& value : values) {
        refuse_bare(value, line);
        if (!value.type.is_number()) {
            throw Refused(line, cpp_type(result) + "(...) around " + cpp_type(value.type));
        }
        components += value.type.components;
        all_one = all_one && value.number && std::fabs(*value.number - 1) == 0;
    }
    const bool splat = values.size() == 1 && values.front().type == scalar_type();
    if (components != result.components && !splat) {
        throw Refused(line, cpp_type(result) + "(...) from " + std::to_string(components) + " components");
    }
    Value value = value_of(result);
    if (all_one) {
        value.number = 1;
    }
    return value;
}

Value ExpressionReader::aggregate(const std::string& name) {
    const unsigned line = tokens_.line();
    const Type result = type();
    const Structure& structure = program_.structures.at(name);
    if (!tokens_.next_is("{")) {
        tokens_.refuse("a struct is built with braces: " + cpp_type(result) + "{...}");
    }
    tokens_.replace("(");
    std::size_t count = 0;
    for (const Variable& member : structure.members) {
        if (tokens_.next_is("}")) {
            break;
        }
        if (count > 0) {
            tokens_.take(",", "a list");
        }
        expression_of(member.type, "member '" + member.name + "' of " + structure.name);
        ++count;
    }
    if (count != structure.members.size() || !tokens_.next_is("}")) {
        throw Refused(line, structure.name + " is built with all of its " +
                                std::to_string(structure.members.size()) + " members in order");
    }
    tokens_.replace(")");
    return value_of(result);
}

Value ExpressionReader::builtin_call() {
    const unsigned line = tokens_.line();
    const std::string name = tokens_.text(2);
    const std::string reason = reason_against_builtin(name);
    if (!reason.empty()) {
        tokens_.refuse("glm::" + name + " is outside the subset: " + reason);
    }
    if (!is_builtin(name)) {
        tokens_.refuse("glm::" + name + " is not in the table of built-ins (tools/glslgen/builtins.cpp)");
    }
    tokens_.drop();
    tokens_.drop();
    tokens_.take();
    called_builtins_.emplace(name, line);
    const std::vector<Value> values = arguments("(", ")");
    std::vector<Type> types;
    bool any_number = false;
    for (const Value& value : values) {
        types.push_back(value.type);
        any_number = any_number || value.type.is_number();
    }
    for (const Value& value : values) {
        if (any_number) {
            refuse_bare(value, line);
        }
        if ((name == "min" || name == "max" || name == "clamp") && is_epsilon(value.number)) {
            refuse_epsilon(line);
        }
    }
    if (name == "pow" && values.size() == 2) {
        refuse_power_of_constant(values, line);
    }
    const std::optional<Type> result = builtin_result(name, types);
    if (!result) {
        throw Refused(line, "glm::" + name + " is called otherwise than " + builtin_usage(name));
    }
    Value value = value_of(*result);
    value.is_exp = name == "exp";
    return value;
}

void ExpressionReader::refuse_power_of_constant(const std::vector<Value>& arguments, unsigned line) const {
    const std::optional<double> exponent = arguments[1].number;
    if (exponent && std::fabs(2 * *exponent - std::round(2 * *exponent)) == 0) {
        throw Refused(
            line,
            "glm::pow with an integer or half-integer exponent: write products and glm::sqrt; pow of "
            "GLSL is undefined below 0 and inherits the errors of exp2 and log2");
    }
}

Value ExpressionReader::scene_member() {
    const unsigned line = tokens_.line();
    const std::string name = tokens_.text(2);
    if (!function_.has_scene) {
        tokens_.refuse("Scene:: in a function without the template parameter Scene");
    }
    const auto flag = program_.flags.find(name);
    if (flag == program_.flags.end()) {
        tokens_.refuse("DefaultScene has no member '" + name + "'");
    }
    if (flag->second.type == boolean_type()) {
        tokens_.refuse("Scene::" + name + " outside if constexpr: a term that is off must not be compiled");
    }
    check_visible(flag->second, line);
    tokens_.drop();
    tokens_.drop();
    tokens_.replace(flag->second.glsl);
    function_.flags.insert(name);
    return value_of(integer_type());
}

Value ExpressionReader::infinity() {
    const std::vector<std::string> expected = {"std", "::", "numeric_limits", "<", "T",
                                               ">",   "::", "infinity",       "("};
    for (const std::string& text : expected) {
        if (!tokens_.next_is(text)) {
            tokens_.refuse("of std:: only std::numeric_limits<T>::infinity() has a GLSL form, 1e30");
        }
        tokens_.drop();
    }
    if (!tokens_.next_is(")")) {
        tokens_.refuse("infinity() takes no argument");
    }
    tokens_.replace("1e30");
    return value_of(scalar_type());
}

Value ExpressionReader::named() {
    const unsigned line = tokens_.line();
    std::size_t length = 1;
    const std::string written =
        tokens_.kind() == TokenKind::identifier ? written_name(length) : tokens_.text();
    if (length == 1) {
        const std::string* hook = hook_of(written);
        if (hook) {
            return hook_call(*hook);
        }
        if (const Local* local = locals_.find(written)) {
            tokens_.take();
            if (tokens_.next_is("(")) {
                tokens_.refuse("'" + written + "' is a local, and called");
            }
            Value value = value_of(local->type);
            value.writable = !local->is_const;
            return value;
        }
    }
    std::string name = lookup(program_.functions, length);
    if (!name.empty()) {
        return own_call(name);
    }
    name = lookup(program_.constants, length);
    if (!name.empty()) {
        return constant(name);
    }
    name = lookup(program_.structures, length);
    if (!name.empty()) {
        return aggregate(name);
    }
    name = lookup(program_.choices, length);
    if (!name.empty()) {
        const Choice& choice = program_.choices.at(name);
        check_visible(choice, line);
        drop_qualifiers(length);
        tokens_.replace(choice.glsl);
        return value_of(integer_type());
    }
    refuse_unknown(written);
    return {};
}

Value ExpressionReader::constant(const std::string& name) {
    const unsigned line = tokens_.line();
    const Constant& found = program_.constants.at(name);
    check_visible(found, line);
    std::size_t length = 1;
    written_name(length);
    drop_qualifiers(length);
    tokens_.drop();
    tokens_.drop("<", "the constant " + name + "<T>");
    tokens_.drop("T", "the constant " + name + "<T>");
    tokens_.replace(found.glsl);
    return value_of(found.type);
}

}  // namespace glslgen
