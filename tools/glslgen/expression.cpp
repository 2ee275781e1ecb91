#include "expression.hpp"

#include <cmath>
#include <map>

#include "expression_parts.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {

namespace {

/// Comparing a quantity with a number below this, or bounding it by one, smells of an absolute epsilon.
constexpr double largest_epsilon = 1e-5;

}  // namespace

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

}  // namespace glslgen
