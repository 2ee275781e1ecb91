#include "line_breaks.hpp"

#include <string>

namespace glslgen {
namespace {

std::size_t indentation_of(const std::string& code) {
    return code.find_first_not_of(' ');
}

/// Where a line may be broken: behind a comma, and the column at which the rest goes on.
struct Break {
    std::size_t position = 0;  ///< of the blank behind the comma; 0 for none
    std::size_t column = 0;
};

/// The last comma before the edge, of those the ones inside fewest parentheses.
Break find_break(const std::string& code) {
    std::vector<std::size_t> columns = {indentation_of(code)};
    std::size_t least_depth = 0;
    Break best;
    for (std::size_t i = columns.front(); i < code.size() && i < widest_line; ++i) {
        if (code[i] == '(' || code[i] == '[') {
            columns.push_back(i + 1);
        } else if ((code[i] == ')' || code[i] == ']') && columns.size() > 1) {
            columns.pop_back();
        } else if (code[i] == ',' && i + 1 < code.size() && code[i + 1] == ' ' &&
                   (!best.position || columns.size() <= least_depth)) {
            least_depth = columns.size();
            best = {i + 1, columns.back()};
        }
    }
    return best;
}

}  // namespace

std::vector<Line> break_long_lines(const std::vector<Line>& lines) {
    std::vector<Line> result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Line line = lines[i];
        const bool directive = !line.code.empty() && line.code.front() == '#';
        while (line.code.size() > widest_line && !directive) {
            const Break where = find_break(line.code);
            if (!where.position) {
                break;
            }
            result.push_back({line.code.substr(0, where.position), "", 0});
            line.code = std::string(where.column, ' ') + line.code.substr(where.position + 1);
            const bool goes_on = i + 1 < lines.size() && line.comment.empty() &&
                                 indentation_of(lines[i + 1].code) == where.column;
            const std::size_t room =
                goes_on ? line.code.size() + 1 + lines[i + 1].code.size() - where.column : 0;
            if (goes_on && room <= widest_line) {
                line.code += " " + lines[i + 1].code.substr(where.column);
                line.comment = lines[i + 1].comment;
                line.comment_column = lines[i + 1].comment_column;
                ++i;
            }
        }
        result.push_back(line);
    }
    return result;
}

}  // namespace glslgen
