#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "header.hpp"
#include "layout.hpp"

namespace glslgen {

/// The tokens of one declaration without its comments, read from left to right, and what becomes of each.
class TokenStream {
  public:
    TokenStream(const Header& header, Edits& edits, std::size_t begin, std::size_t end);

    bool at_end() const {
        return position_ >= indices_.size();
    }
    /// Text of the next token but `ahead`; empty past the end.
    const std::string& text(std::size_t ahead = 0) const;
    bool next_is(const std::string& expected) const {
        return text() == expected;
    }
    TokenKind kind(std::size_t ahead = 0) const;
    unsigned line() const;
    /// Index in the header of the next token. Throws Refused at the end.
    std::size_t index() const;

    /// Passes one token and returns its index in the header.
    std::size_t take();
    std::size_t take(const std::string& expected, const std::string& where);
    std::size_t drop();
    std::size_t drop(const std::string& expected, const std::string& where);
    std::size_t replace(const std::string& replacement);
    /// Passes the next token if it is the expected one.
    bool take_if(const std::string& expected);
    bool drop_if(const std::string& expected);
    /// Puts blanks around the next token where the header has none.
    void space_around();

    Edit& edit(std::size_t index) {
        return edits_[index];
    }
    const Token& token(std::size_t index) const {
        return header_.tokens[index];
    }
    const Header& header() const {
        return header_;
    }

    [[noreturn]] void refuse(const std::string& reason) const;

  private:
    const Header& header_;
    Edits& edits_;
    std::vector<std::size_t> indices_;
    std::size_t position_ = 0;
};

/// Index of the first token of a header that begins at or after an offset.
std::size_t first_token_at(const Header& header, std::size_t offset);

}  // namespace glslgen
