#pragma once

#include "header.hpp"
#include "layout.hpp"
#include "model.hpp"

namespace glslgen {

/// Reads the body of a function (offsets of its braces), fills in what it calls and which flags and hooks it
/// reaches, and edits its tokens. Throws Refused.
void read_body(const Program& program, const Header& header, Edits& edits, Function& function,
               const std::string& space, std::size_t begin, std::size_t end);

}  // namespace glslgen
