#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "header.hpp"
#include "layout.hpp"
#include "model.hpp"
#include "token_stream.hpp"

namespace glslgen {

/// The comments around a declaration.
struct Comments {
    std::vector<const Token*> doc;       ///< the block that ends on the line above it
    std::vector<const Token*> trailing;  ///< on the line where it ends
    bool in_group = false;               ///< follows the declaration before it without a blank line
};

/// What every reader of one kind of declaration works on.
struct Site {
    const Header& header;
    const Declaration& declaration;
    const Comments& comments;
    Edits& edits;
    Program& program;
};

/// Tokens [first, last) of a declaration with its closing semicolon.
struct TokenRange {
    std::size_t first = 0;
    std::size_t last = 0;
};

TokenRange range_of(const Site& site);
TokenStream stream_of(const Site& site);

/// Name, GLSL name and header of the declaration.
Named named(const Site& site);

/// Passes `template <typename T>`, which GLSL does without.
void drop_scalar_template(TokenStream& tokens);

/// Comments as lines of GLSL, without the common indentation.
std::vector<Line> comment_lines(const std::vector<const Token*>& comments);

/// The comments of a declaration as text, for checks.
std::vector<std::string> comment_texts(const std::vector<const Token*>& comments);

/// Comments of a member whose first token and semicolon are given: the lines above it and what stands behind.
std::vector<const Token*> member_comments(const Header& header, std::size_t first, std::size_t semicolon);

/// Trailing comment of a declaration in one string.
std::string trailing_text(const Comments& comments);

}  // namespace glslgen
