#include "layout.hpp"

#include <algorithm>

#include "line_breaks.hpp"

namespace glslgen {
namespace {

constexpr unsigned indent_width = 4;

/// A token that was written: where it stood, and where it stands now (columns counted from 1).
struct Placed {
    unsigned line = 0;
    unsigned old_column = 0;
    unsigned new_column = 0;
};

class Layout {
  public:
    Layout(const Header& header, const Edits& edits) : header_(header), edits_(edits) {}

    std::vector<Line> run(std::size_t first, std::size_t last) {
        std::size_t run_start = first;
        for (std::size_t i = first; i < last; ++i) {
            const Edit& edit = edits_[i];
            if (edit.kind != Edit::Kind::drop) {
                const std::size_t gap_begin = run_start == 0 ? 0 : header_.tokens[run_start - 1].end;
                const std::string gap =
                    run_start == first
                        ? std::string()
                        : header_.text.substr(gap_begin, header_.tokens[run_start].begin - gap_begin);
                place(i, run_start, gap);
                run_start = i + 1;
            }
        }
        return std::move(lines_);
    }

  private:
    void place(std::size_t index, std::size_t run_start, const std::string& gap) {
        const Token& token = header_.tokens[index];
        const Edit& edit = edits_[index];
        const bool comment = token.kind == TokenKind::comment;
        const auto breaks = static_cast<std::size_t>(std::count(gap.begin(), gap.end(), '\n'));
        if (edit.kind == Edit::Kind::directive) {
            add_blank_lines(breaks);
            lines_.push_back({edit.text, "", 0});
            after_directive_ = true;
            statement_.clear();
            return;
        }
        const bool new_line = lines_.empty() || breaks > 0 || (after_directive_ && !comment);
        if (new_line) {
            add_blank_lines(breaks);
            lines_.push_back({});
        }
        const unsigned old_column = edit.column ? edit.column : header_.tokens[run_start].column;
        if (comment) {
            place_comment(token, edit, new_line);
            after_directive_ = after_directive_ && !new_line;
            return;
        }
        after_directive_ = false;
        if (edit.statement) {
            statement_.clear();
        }
        std::string& code = lines_.back().code;
        if (new_line) {
            code.assign(new_indentation(edit, old_column), ' ');
        } else {
            code += gap;
        }
        const unsigned new_column = static_cast<unsigned>(code.size()) + 1;
        statement_.push_back({token.line, old_column, new_column});
        if (token.column != old_column) {
            statement_.push_back({token.line, token.column, new_column});
        }
        code += edit.kind == Edit::Kind::replace ? edit.text : token.text;
        if (!edit.after.empty()) {
            lines_.push_back({edit.after, "", 0});
            after_directive_ = true;
            statement_.clear();
        }
    }

    void place_comment(const Token& token, const Edit& edit, bool new_line) {
        Line& line = lines_.back();
        if (new_line) {
            line.code.assign(dedented(token.column, edit), ' ');
        }
        if (!line.comment.empty()) {
            line.comment += ' ';
        }
        line.comment += glsl_comment(token.text);
        line.comment_column = token.column;
    }

    void add_blank_lines(std::size_t breaks) {
        for (std::size_t i = 1; i < breaks && !lines_.empty(); ++i) {
            lines_.push_back({});
        }
    }

    static unsigned dedented(unsigned column, const Edit& edit) {
        const unsigned removed = indent_width * static_cast<unsigned>(edit.dedent);
        return column - 1 > removed ? column - 1 - removed : 0;
    }

    /// Columns of blanks before the first token of a line.
    unsigned new_indentation(const Edit& edit, unsigned old_column) const {
        if (statement_.empty()) {
            return dedented(old_column, edit);
        }
        // A continued line: below the latest token that it stood below in the header.
        for (auto placed = statement_.rbegin(); placed != statement_.rend(); ++placed) {
            if (placed->old_column == old_column) {
                return placed->new_column - 1;
            }
        }
        return dedented(old_column, edit);
    }

    const Header& header_;
    const Edits& edits_;
    std::vector<Line> lines_;
    std::vector<Placed> statement_;  ///< tokens of the statement being written
    bool after_directive_ = false;
};

bool is_blank(const std::string& text) {
    return text.find_first_not_of(' ') == std::string::npos;
}

/// Lines [first, end) whose trailing comments are put into one column, which is `width` blanks behind the
/// start of the line. Ends where the column would push a comment over the edge.
struct CommentBlock {
    std::size_t end = 0;
    std::size_t width = 0;
};

CommentBlock comment_block(const std::vector<Line>& lines, std::size_t first) {
    CommentBlock block{first, 0};
    std::size_t longest_comment = 0;
    for (; block.end < lines.size() && !lines[block.end].comment.empty(); ++block.end) {
        const Line& line = lines[block.end];
        const bool alone = is_blank(line.code);
        if (alone && line.comment_column != lines[block.end - 1].comment_column) {
            break;
        }
        const std::size_t width = std::max(block.width, alone ? 0 : line.code.size());
        const std::size_t comment = std::max(longest_comment, line.comment.size());
        if (block.end > first && width + 2 + comment > widest_line) {
            break;
        }
        block.width = width;
        longest_comment = comment;
    }
    return block;
}

}  // namespace

std::string glsl_comment(const std::string& text) {
    if (text.compare(0, 4, "///<") == 0) {
        return "//" + text.substr(4);
    }
    if (text.compare(0, 3, "///") == 0) {
        return "//" + text.substr(3);
    }
    return text;
}

std::vector<Line> lay_out(const Header& header, const Edits& edits, std::size_t first, std::size_t last) {
    return Layout(header, edits).run(first, last);
}

std::string joined_code(const std::vector<Line>& lines) {
    std::string text;
    for (const Line& line : lines) {
        if (!is_blank(line.code)) {
            text += text.empty() || text.back() == '(' ? "" : " ";
            text += line.code.substr(line.code.find_first_not_of(' '));
        }
    }
    return text;
}

std::string join(const std::vector<Line>& unbroken) {
    const std::vector<Line> lines = break_long_lines(unbroken);
    std::string text;
    std::size_t i = 0;
    while (i < lines.size()) {
        const Line& line = lines[i];
        if (line.comment.empty() || is_blank(line.code)) {
            text += is_blank(line.code) && line.comment.empty() ? "" : line.code + line.comment;
            text += '\n';
            ++i;
            continue;
        }
        const CommentBlock block = comment_block(lines, i);
        for (; i < block.end; ++i) {
            const std::string code = is_blank(lines[i].code) ? std::string() : lines[i].code;
            text += code + std::string(block.width - code.size() + 2, ' ') + lines[i].comment + '\n';
        }
    }
    return text;
}

}  // namespace glslgen
