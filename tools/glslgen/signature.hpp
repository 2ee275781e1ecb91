#pragma once

#include <string>

#include "header.hpp"
#include "model.hpp"

namespace glslgen {

/// The type that clang spells `const vec3<T> &`, as a parameter or a result. Throws Refused for what is
/// outside the subset; `whose` says in messages which type it is.
Type spelled_type(const Program& program, const std::string& spelling, const std::string& scope,
                  const std::string& whose, unsigned line);

/// Fills in what a function's declaration says of it: parameters, result, Scene, hooks (registering new
/// hooks in the program). Throws Refused.
void read_signature(Program& program, const Header& header, const Declaration& declaration,
                    Function& function);

/// "float airlight_f(vec3 a, float b)", broken after commas where a line would be too long.
std::vector<Line> signature_lines(const Function& function);

}  // namespace glslgen
