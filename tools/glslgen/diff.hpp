#pragma once

#include <string>

namespace glslgen {

/// Unified diff with three lines of context that turns `before` into `after`; empty when they are equal.
std::string unified_diff(const std::string& before, const std::string& after, const std::string& before_name,
                         const std::string& after_name);

}  // namespace glslgen
