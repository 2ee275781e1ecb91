#include "expression.hpp"

#include <cmath>
#include <cstdlib>

#include "builtins.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

/// Comparing a quantity with a number below this, or bounding it by one, smells of an absolute epsilon.
constexpr double largest_epsilon = 1e-5;

int precedence(const std::string& symbol) {
    static const std::map<std::string, int> levels = {{"||", 1}, {"&&", 2}, {"==", 3}, {"!=", 3}, {"<", 4},
                                                      {">", 4},  {"<=", 4}, {">=", 4}, {"+", 5},  {"-", 5},
                                                      {"*", 6},  {"/", 6},  {"%", 6}};
    const auto level = levels.find(symbol);
    return level == levels.end() ? 0 : level->second;
}

bool is_epsilon(const std::optional<double>& number) {
    return number && *number != 0 && std::fabs(*number) <= largest_epsilon;
}

[[noreturn]] void refuse_epsilon(unsigned line) {
    throw Refused(
        line,
        "an absolute epsilon: with another unit of length the result changes. Compare quantities of "
        "one kind, or name the number in constants.hpp with its unit and reason");
}

Value value_of(const Type& type) {
    Value value;
    value.type = type;
    return value;
}

bool is_vector_name(const std::string& name) {
    return name == "vec2" || name == "vec3" || name == "vec4";
}

}  // namespace

void Locals::declare(const std::string& name, const Local& local) {
    if (!scopes_.back().emplace(name, local).second) {
        throw Refused(local.line, "'" + name + "' is declared twice");
    }
}

const Local* Locals::find(const std::string& name) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
        const auto local = scope->find(name);
        if (local != scope->end()) {
            return &local->second;
        }
    }
    return nullptr;
}

ExpressionReader::ExpressionReader(const Program& program, TokenStream& tokens, Locals& locals,
                                   Function& function, const std::string& space)
    : program_(program), tokens_(tokens), locals_(locals), function_(function), space_(space) {}

// ---- names -----------------------------------------------------------------------------------------------

std::string ExpressionReader::written_name(std::size_t& length) const {
    std::string name = tokens_.text();
    length = 1;
    while (tokens_.text(length) == "::" && tokens_.kind(length + 1) == TokenKind::identifier) {
        name += "::" + tokens_.text(length + 1);
        length += 2;
    }
    return name.rfind("airlight::", 0) == 0 ? name.substr(10) : name;
}

template <typename Entry>
std::string ExpressionReader::lookup(const std::map<std::string, Entry>& table, std::size_t& length) const {
    if (tokens_.kind() != TokenKind::identifier) {
        return "";
    }
    const std::string written = written_name(length);
    for (const std::string& name : {space_ + written, written}) {
        if (table.count(name)) {
            return name;
        }
    }
    return "";
}

void ExpressionReader::drop_qualifiers(std::size_t length) {
    for (std::size_t i = 1; i < length; ++i) {
        tokens_.drop();
    }
}

void ExpressionReader::check_visible(const Named& named, unsigned line) const {
    if (!tokens_.header().visible.count(named.header)) {
        throw Refused(line, "'" + named.name + "' is declared in " + named.header +
                                ", which this header does not include");
    }
}

void ExpressionReader::refuse_unknown(const std::string& name) const {
    for (const std::string& full : {space_ + name, name}) {
        if (program_.refused.count(full)) {
            throw FollowsFromRefusal();
        }
        if (program_.cpu_only.count(full)) {
            tokens_.refuse("'" + full + "' is marked AIRLIGHT_CPU_ONLY and has no GLSL");
        }
    }
    if (name.rfind("std::", 0) == 0) {
        tokens_.refuse("'" + name + "' is outside the subset: nothing of std:: exists in GLSL");
    }
    const std::string reason = reason_against_word(name);
    if (!reason.empty()) {
        tokens_.refuse("'" + name + "' is outside the subset: " + reason);
    }
    tokens_.refuse(
        "'" + name +
        "' is unknown here: not a local, a built-in (glm::), or a declaration of airlight that stands "
        "before this one");
}

std::string ExpressionReader::drop_text() {
    return tokens_.token(tokens_.drop()).text;
}

// ---- types -----------------------------------------------------------------------------------------------

bool ExpressionReader::at_type() const {
    const std::string& text = tokens_.text();
    if (text == "T" || text == "int" || text == "bool") {
        return tokens_.text(1) != "(" && tokens_.text(1) != "{";
    }
    std::size_t length = 1;
    if (!is_vector_name(text) && lookup(program_.structures, length).empty()) {
        return false;
    }
    // Name<T> followed by a name or a reference; Name<T>( and Name<T>{ are values.
    return tokens_.text(length) == "<" && tokens_.text(length + 3) != "(" && tokens_.text(length + 3) != "{";
}

Type ExpressionReader::type() {
    const std::string text = tokens_.text();
    const unsigned line = tokens_.line();
    Type result;
    if (text == "T") {
        tokens_.replace("float");
        result = scalar_type();
    } else if (text == "int" || text == "bool") {
        tokens_.take();
        result = text == "int" ? integer_type() : boolean_type();
    } else {
        std::size_t length = 1;
        const std::string structure = is_vector_name(text) ? "" : lookup(program_.structures, length);
        if (!is_vector_name(text) && structure.empty()) {
            refuse_unknown(written_name(length));
        }
        if (structure.empty()) {
            result = vector_type(text[3] - '0');
        } else {
            check_visible(program_.structures.at(structure), line);
            result = structure_type(structure);
        }
        drop_qualifiers(length);
        tokens_.drop();
        tokens_.drop("<", "the type");
        tokens_.drop("T", "the type");
        if (!tokens_.next_is(">")) {
            tokens_.refuse("a type has the one template argument T");
        }
        tokens_.replace(glsl_type(result));
    }
    if (tokens_.next_is("&") || tokens_.next_is("&&")) {
        tokens_.refuse("a reference: GLSL copies values; leave the & away");
    }
    if (tokens_.next_is("*")) {
        tokens_.refuse("a pointer: GLSL has none");
    }
    return result;
}

// ---- operators -------------------------------------------------------------------------------------------

Value ExpressionReader::expression() {
    return conditional();
}

Value ExpressionReader::expression_of(const Type& expected, const std::string& where) {
    const unsigned line = tokens_.line();
    const Value value = expression();
    if (value.type != expected) {
        if (expected == scalar_type()) {
            refuse_bare(value, line);
        }
        throw Refused(line, where + " needs " + cpp_type(expected) + ", not " + cpp_type(value.type));
    }
    return value;
}

void ExpressionReader::refuse_bare(const Value& value, unsigned line) const {
    if (value.bare_literal) {
        throw Refused(line, "a bare literal where a T is needed: write T(...) around it");
    }
    if (value.type.is(Type::Kind::integer)) {
        throw Refused(line, "an int where a T is needed: write T(...) around it");
    }
}

Value ExpressionReader::conditional() {
    const Value condition = binary(1);
    if (!tokens_.next_is("?")) {
        return condition;
    }
    const unsigned line = tokens_.line();
    if (!condition.type.is(Type::Kind::boolean)) {
        tokens_.refuse("the condition of ?: is no bool");
    }
    tokens_.take();
    const Value yes = expression();
    tokens_.take(":", "?:");
    const Value no = expression();
    if (yes.type == scalar_type()) {
        refuse_bare(no, line);
    }
    if (no.type == scalar_type()) {
        refuse_bare(yes, line);
    }
    if (yes.type != no.type) {
        throw Refused(line, "?: between " + cpp_type(yes.type) + " and " + cpp_type(no.type));
    }
    if (yes.type.is_array() || yes.type.is(Type::Kind::vector) || yes.type.is(Type::Kind::structure)) {
        throw Refused(line,
                      "?: chooses between scalars only, not " + cpp_type(yes.type) + ": write if and else");
    }
    return value_of(yes.type);
}

Value ExpressionReader::binary(int least_precedence) {
    Value left = unary();
    for (;;) {
        const std::string symbol = tokens_.text();
        const int level = precedence(symbol);
        if (level == 0 || level < least_precedence) {
            const std::string reason = level == 0 ? reason_against_word(symbol) : "";
            if (!reason.empty()) {
                tokens_.refuse("'" + symbol + "' is outside the subset: " + reason);
            }
            return left;
        }
        const unsigned line = tokens_.line();
        tokens_.space_around();
        tokens_.take();
        const Value right = binary(level + 1);
        if (level <= 2) {
            if (!left.type.is(Type::Kind::boolean) || !right.type.is(Type::Kind::boolean)) {
                throw Refused(line, "both sides of " + symbol + " must be bool");
            }
            left = value_of(boolean_type());
        } else if (level <= 4) {
            left = comparison(symbol, left, right, line);
        } else {
            left = arithmetic(symbol, left, right, line);
        }
    }
}

Value ExpressionReader::comparison(const std::string& symbol, const Value& left, const Value& right,
                                   unsigned line) {
    if (left.type == scalar_type() || right.type == scalar_type()) {
        refuse_bare(left, line);
        refuse_bare(right, line);
    }
    const bool equality = symbol == "==" || symbol == "!=";
    const bool comparable = left.type == scalar_type() || left.type == integer_type() ||
                            (equality && left.type == boolean_type());
    if (left.type != right.type || !comparable) {
        throw Refused(line, "'" + symbol + "' compares two T or two int, not " + cpp_type(left.type) +
                                " and " + cpp_type(right.type));
    }
    if (is_epsilon(left.number) || is_epsilon(right.number)) {
        refuse_epsilon(line);
    }
    return value_of(boolean_type());
}

Value ExpressionReader::arithmetic(const std::string& symbol, const Value& left, const Value& right,
                                   unsigned line) {
    if (symbol == "%") {
        throw Refused(line, "% is undefined in GLSL where an operand is negative");
    }
    const bool scalars = left.type == scalar_type() || right.type == scalar_type();
    if (left.type.is_number() || right.type.is_number()) {
        refuse_bare(left, line);
        refuse_bare(right, line);
    }
    if (symbol == "-" && function_.name != "one_minus_exp") {
        const bool one_left = left.number && std::fabs(*left.number - 1) == 0;
        const bool one_right = right.number && std::fabs(*right.number - 1) == 0;
        if ((one_left && right.is_exp) || (left.is_exp && one_right)) {
            throw Refused(line, "1 - exp(-x) loses every digit of a small x: call one_minus_exp(x)");
        }
    }
    if (left.type == right.type && (left.type.is_number() || left.type == integer_type())) {
        Value result = value_of(left.type);
        result.bare_literal = left.bare_literal && right.bare_literal;
        return result;
    }
    if (scalars && left.type.is_number() && right.type.is_number()) {
        return value_of(left.type == scalar_type() ? right.type : left.type);
    }
    throw Refused(line, "'" + symbol + "' between " + cpp_type(left.type) + " and " + cpp_type(right.type));
}

Value ExpressionReader::unary() {
    const std::string symbol = tokens_.text();
    const unsigned line = tokens_.line();
    if (symbol == "-") {
        tokens_.take();
        if (tokens_.next_is("-") || (tokens_.next_is("T") && tokens_.text(2) == "-")) {
            throw Refused(line, "two minus signs in a row");
        }
        Value value = unary();
        if (!value.type.is_number() && value.type != integer_type()) {
            throw Refused(line, "'-' before " + cpp_type(value.type));
        }
        if (value.number) {
            value.number = -*value.number;
        }
        value.is_exp = value.writable = false;
        return value;
    }
    if (symbol == "!") {
        tokens_.take();
        if (!unary().type.is(Type::Kind::boolean)) {
            throw Refused(line, "'!' before something that is no bool");
        }
        return value_of(boolean_type());
    }
    if (symbol == "++" || symbol == "--") {
        tokens_.refuse("'" + symbol + "' stands only in the head of a for loop; write += 1");
    }
    if (symbol == "*" || symbol == "&") {
        tokens_.refuse("a pointer: GLSL has none");
    }
    if (symbol == "+") {
        tokens_.refuse("a plus sign without a left side");
    }
    return postfix();
}

Value ExpressionReader::postfix() {
    Value value = primary();
    for (;;) {
        const unsigned line = tokens_.line();
        if (tokens_.next_is(".")) {
            tokens_.take();
            const std::string member = tokens_.text();
            if (value.type.is(Type::Kind::vector)) {
                const std::string allowed =
                    std::string("xyzw").substr(0, static_cast<std::size_t>(value.type.components));
                if (member.size() != 1 || allowed.find(member) == std::string::npos) {
                    throw Refused(line, "'." + member + "': of " + cpp_type(value.type) +
                                            " only one component at a time, ." + allowed.substr(0, 1) +
                                            " to ." + allowed.back());
                }
                value.type = scalar_type();
            } else if (value.type.is(Type::Kind::structure)) {
                const Structure& structure = program_.structures.at(value.type.structure);
                const Variable* found = nullptr;
                for (const Variable& variable : structure.members) {
                    found = variable.name == member ? &variable : found;
                }
                if (!found) {
                    throw Refused(line, structure.name + " has no member '" + member + "'");
                }
                value.type = found->type;
            } else {
                throw Refused(line, "'." + member + "' after " + cpp_type(value.type));
            }
            tokens_.take();
        } else if (tokens_.next_is("[")) {
            if (!value.type.is_array()) {
                throw Refused(line, "an index into " + cpp_type(value.type) +
                                        ": only arrays have one; name a component .x .y .z .w");
            }
            tokens_.take();
            expression_of(integer_type(), "an index");
            tokens_.take("]", "an index");
            value.type = value.type.element();
        } else if (tokens_.next_is("++") || tokens_.next_is("--")) {
            tokens_.refuse("'" + tokens_.text() + "' stands only in the head of a for loop; write += 1");
        } else {
            return value;
        }
        value.number.reset();
        value.is_exp = value.bare_literal = false;
    }
}

// ---- primary expressions ---------------------------------------------------------------------------------

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
    const std::size_t open = tokens_.replace("(");
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
    static_cast<void>(open);
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

// ---- calls of own functions and hooks --------------------------------------------------------------------

const std::string* ExpressionReader::hook_of(const std::string& parameter) const {
    for (std::size_t i = 0; i < function_.hook_names.size(); ++i) {
        if (function_.hook_names[i] == parameter) {
            return &function_.hooks[i];
        }
    }
    return nullptr;
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
    const std::vector<Value> values = arguments("(", ")");
    bool fits = values.size() == functor.parameters.size();
    for (std::size_t i = 0; fits && i < values.size(); ++i) {
        fits = values[i].type == functor.parameters[i].type;
    }
    if (!fits) {
        throw Refused(line,
                      "the hook " + hook + " is called otherwise than " + functor.name + "::operator()");
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
    bool known = false;
    for (const std::string& call : function_.calls) {
        known = known || call == name;
    }
    if (!known) {
        function_.calls.push_back(name);
    }
    function_.flags.insert(callee.flags.begin(), callee.flags.end());
    function_.all_hooks.insert(callee.all_hooks.begin(), callee.all_hooks.end());
    return value_of(callee.result);
}

// ---- what the compiler must know -------------------------------------------------------------------------

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
