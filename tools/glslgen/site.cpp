#include "site.hpp"

#include "refusal.hpp"

namespace glslgen {

TokenRange range_of(const Site& site) {
    TokenRange range;
    range.first = first_token_at(site.header, site.declaration.begin);
    range.last = first_token_at(site.header, site.declaration.end);
    if (range.last < site.header.tokens.size() && site.header.tokens[range.last].text == ";") {
        ++range.last;
    }
    return range;
}

TokenStream stream_of(const Site& site) {
    const std::size_t end = site.header.tokens[range_of(site).last - 1].end;
    return TokenStream(site.header, site.edits, site.declaration.begin, end);
}

Named named(const Site& site) {
    Named result;
    result.name = site.declaration.full_name();
    result.glsl = glsl_name(result.name);
    result.header = site.header.name;
    return result;
}

void drop_scalar_template(TokenStream& tokens) {
    for (const char* word : {"template", "<", "typename", "T", ">"}) {
        if (!tokens.next_is(word)) {
            tokens.refuse("'" + tokens.text() + "' where template <typename T> is needed");
        }
        tokens.drop();
    }
}

std::vector<Line> comment_lines(const std::vector<const Token*>& comments) {
    std::vector<Line> lines;
    for (const Token* comment : comments) {
        lines.push_back({"", glsl_comment(comment->text), 0});
    }
    return lines;
}

std::vector<std::string> comment_texts(const std::vector<const Token*>& comments) {
    std::vector<std::string> texts;
    for (const Token* comment : comments) {
        texts.push_back(comment->text);
    }
    return texts;
}

std::vector<const Token*> member_comments(const Header& header, std::size_t first, std::size_t semicolon) {
    const std::vector<Token>& tokens = header.tokens;
    std::vector<const Token*> result;
    std::size_t above = first;
    while (above > 1 && tokens[above - 1].kind == TokenKind::comment &&
           tokens[above - 1].line + 1 == tokens[above].line &&
           tokens[above - 2].line != tokens[above - 1].line &&
           tokens[above - 1].column == tokens[first].column) {
        --above;
    }
    for (std::size_t i = above; i < first; ++i) {
        result.push_back(&tokens[i]);
    }
    for (std::size_t i = semicolon + 1; i < tokens.size() && tokens[i].kind == TokenKind::comment; ++i) {
        const bool same_line = tokens[i].line == tokens[semicolon].line;
        const bool goes_on = i > semicolon + 1 && tokens[i].column == tokens[semicolon + 1].column &&
                             tokens[semicolon + 1].line == tokens[semicolon].line;
        if (!same_line && !goes_on) {
            break;
        }
        result.push_back(&tokens[i]);
    }
    return result;
}

std::string trailing_text(const Comments& comments) {
    std::string text;
    for (const Token* comment : comments.trailing) {
        text += (text.empty() ? "" : " ") + glsl_comment(comment->text);
    }
    return text;
}

}  // namespace glslgen
