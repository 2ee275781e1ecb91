#pragma once

#include <string>
#include <vector>

#include "header.hpp"

namespace glslgen {

/// Throws Refused when a name cannot be an identifier in GLSL.
void check_identifier(const std::string& name, unsigned line);

/// Why a word of C++ is outside the subset; empty for a word that may stand in a translated declaration.
std::string reason_against_word(const std::string& word);

/// Throws Refused at the first token of a declaration that no translated declaration may hold; what ends
/// before `head_end` is a function's head.
void check_words(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
                 std::size_t head_end = 0);

/// Throws Refused unless the comment block is a docstring with the five labels.
void check_function_docstring(const std::vector<std::string>& lines, const std::string& name, unsigned line);

/// Throws Refused for characters outside ASCII, which shader compilers need not accept.
void check_ascii(const Token& token);

/// GLSL spelling of the number in `T(...)`: "2" becomes "2.0". Throws Refused for suffixes and for
/// numbers that a GLSL float cannot hold.
std::string scalar_literal(const std::string& text, unsigned line);

/// Throws Refused unless `text` is a plain decimal int.
void check_integer_literal(const std::string& text, unsigned line);

/// A literal of C++ that has a fraction, an exponent or a suffix: no int.
bool is_fractional(const std::string& text);

}  // namespace glslgen
