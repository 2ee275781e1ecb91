#pragma once

#include <optional>
#include <string>

#include "expression.hpp"

// What the files that hold ExpressionReader share.

namespace glslgen {

/// Binding strength of a binary operator, 0 for none: 1 and 2 join bools, 3 and 4 compare, 5 and 6 compute.
int precedence(const std::string& symbol);

/// A number so small that comparing with it, or bounding by it, smells of an absolute epsilon.
bool is_epsilon(const std::optional<double>& number);

[[noreturn]] void refuse_epsilon(unsigned line);

/// A value of which nothing but the type is known.
Value value_of(const Type& type);

/// "vec2", "vec3" or "vec4".
bool is_vector_name(const std::string& name);

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

}  // namespace glslgen
