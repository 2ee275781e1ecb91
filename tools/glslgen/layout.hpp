#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "header.hpp"

namespace glslgen {

/// What becomes of one token. The blanks before a run of dropped tokens go before the token that ends it.
struct Edit {
    enum class Kind { keep, drop, replace, directive };
    Kind kind = Kind::keep;
    std::string text;        ///< of a replacement, or of a whole preprocessor line
    int dedent = 0;          ///< levels of braces around it that disappear
    bool statement = false;  ///< begins a statement or a member, so its line keeps its own indentation
    unsigned column = 0;     ///< read the token as standing here, when not 0
    std::string after;       ///< a preprocessor line that follows the token
};

/// One edit per token of a header.
using Edits = std::vector<Edit>;

/// Where lines are broken, as in the headers.
inline constexpr std::size_t widest_line = 110;

/// A line of GLSL. Trailing comments stay apart from the code until all lines are known.
struct Line {
    std::string code;
    std::string comment;
    unsigned comment_column = 0;  ///< where the comment stood in the header, 0 for none
};

/// Comment of C++ as a comment of GLSL: `///` and `///<` become `//`.
std::string glsl_comment(const std::string& text);

/// The tokens [first, last) with their edits, as lines. Keeps the author's line breaks, blank lines and
/// indentation; what stood under a token of an earlier line still stands under it.
std::vector<Line> lay_out(const Header& header, const Edits& edits, std::size_t first, std::size_t last);

/// The code of the lines in one, with single blanks between them.
std::string joined_code(const std::vector<Line>& lines);

/// Lines as text; trailing comments that stood in one column of the header are put in one column again.
std::string join(const std::vector<Line>& lines);

}  // namespace glslgen
