#pragma once

#include <optional>
#include <string>
#include <vector>

#include "type.hpp"

namespace glslgen {

bool is_builtin(const std::string& name);

/// Why a function of GLM that GLSL has too is kept out on purpose; empty when the table just lacks it.
std::string reason_against_builtin(const std::string& name);

/// Type of glm::name(arguments...), or nothing when GLSL has no such overload. `name` must be a built-in.
std::optional<Type> builtin_result(const std::string& name, const std::vector<Type>& arguments);

/// The calls that a built-in accepts, for messages: "max(x, x) or max(vector, T)".
std::string builtin_usage(const std::string& name);

}  // namespace glslgen
