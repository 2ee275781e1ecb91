#include "token_stream.hpp"

#include <algorithm>

#include "refusal.hpp"

namespace glslgen {

std::size_t first_token_at(const Header& header, std::size_t offset) {
    const auto found =
        std::lower_bound(header.tokens.begin(), header.tokens.end(), offset,
                         [](const Token& token, std::size_t value) { return token.begin < value; });
    return static_cast<std::size_t>(found - header.tokens.begin());
}

TokenStream::TokenStream(const Header& header, Edits& edits, std::size_t begin, std::size_t end)
    : header_(header), edits_(edits) {
    for (std::size_t i = first_token_at(header, begin); i < header.tokens.size(); ++i) {
        if (header.tokens[i].begin >= end) {
            break;
        }
        if (header.tokens[i].kind != TokenKind::comment) {
            indices_.push_back(i);
        }
    }
}

const std::string& TokenStream::text(std::size_t ahead) const {
    static const std::string nothing;
    return position_ + ahead < indices_.size() ? header_.tokens[indices_[position_ + ahead]].text : nothing;
}

TokenKind TokenStream::kind(std::size_t ahead) const {
    return position_ + ahead < indices_.size() ? header_.tokens[indices_[position_ + ahead]].kind
                                               : TokenKind::punctuation;
}

unsigned TokenStream::line() const {
    if (indices_.empty()) {
        return 0;
    }
    return header_.tokens[indices_[std::min(position_, indices_.size() - 1)]].line;
}

std::size_t TokenStream::index() const {
    if (at_end()) {
        refuse("the declaration ends too early");
    }
    return indices_[position_];
}

std::size_t TokenStream::take() {
    const std::size_t result = index();
    ++position_;
    return result;
}

std::size_t TokenStream::take(const std::string& expected, const std::string& where) {
    if (!next_is(expected)) {
        refuse("'" + text() + "' where " + where + " needs '" + expected + "'");
    }
    return take();
}

std::size_t TokenStream::drop() {
    const std::size_t index = take();
    edits_[index].kind = Edit::Kind::drop;
    return index;
}

std::size_t TokenStream::drop(const std::string& expected, const std::string& where) {
    const std::size_t index = take(expected, where);
    edits_[index].kind = Edit::Kind::drop;
    return index;
}

std::size_t TokenStream::replace(const std::string& replacement) {
    const std::size_t index = take();
    edits_[index].kind = Edit::Kind::replace;
    edits_[index].text = replacement;
    return index;
}

bool TokenStream::take_if(const std::string& expected) {
    const bool found = next_is(expected);
    if (found) {
        take();
    }
    return found;
}

bool TokenStream::drop_if(const std::string& expected) {
    const bool found = next_is(expected);
    if (found) {
        drop();
    }
    return found;
}

void TokenStream::space_around() {
    const std::size_t here = index();
    const Token& token = header_.tokens[here];
    const bool before = here > 0 && header_.tokens[here - 1].end == token.begin;
    const bool behind = here + 1 < header_.tokens.size() && header_.tokens[here + 1].begin == token.end;
    if (before || behind) {
        edits_[here].kind = Edit::Kind::replace;
        edits_[here].text = (before ? " " : "") + token.text + (behind ? " " : "");
    }
}

void TokenStream::refuse(const std::string& reason) const {
    throw Refused(line(), reason);
}

}  // namespace glslgen
