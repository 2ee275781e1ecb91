#include "diff.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace glslgen {
namespace {

constexpr std::size_t context = 3;

struct Step {
    char mark;  ///< ' ', '-' or '+'
    std::string text;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    if (!text.empty() && text.back() != '\n') {
        lines.back() += "\n\\ No newline at end of file";
    }
    return lines;
}

/// The longest common subsequence decides what stays. Equal ends are cut off first, so the table is small.
std::vector<Step> steps(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    std::size_t head = 0;
    while (head < a.size() && head < b.size() && a[head] == b[head]) {
        ++head;
    }
    std::size_t tail = 0;
    while (tail < a.size() - head && tail < b.size() - head &&
           a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) {
        ++tail;
    }
    const std::size_t n = a.size() - head - tail;
    const std::size_t m = b.size() - head - tail;
    std::vector<std::vector<unsigned>> common(n + 1, std::vector<unsigned>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = m; j-- > 0;) {
            common[i][j] = a[head + i] == b[head + j] ? common[i + 1][j + 1] + 1
                                                      : std::max(common[i + 1][j], common[i][j + 1]);
        }
    }
    std::vector<Step> result;
    for (std::size_t i = 0; i < head; ++i) {
        result.push_back({' ', a[i]});
    }
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < n || j < m) {
        if (i < n && j < m && a[head + i] == b[head + j]) {
            result.push_back({' ', a[head + i]});
            ++i;
            ++j;
        } else if (i < n && (j == m || common[i + 1][j] >= common[i][j + 1])) {
            result.push_back({'-', a[head + i++]});
        } else {
            result.push_back({'+', b[head + j++]});
        }
    }
    for (std::size_t k = a.size() - tail; k < a.size(); ++k) {
        result.push_back({' ', a[k]});
    }
    return result;
}

/// An empty range is said to stand behind the line before it.
std::string hunk_range(std::size_t first, std::size_t count) {
    return std::to_string(count == 0 ? first - 1 : first) + "," + std::to_string(count);
}

}  // namespace

std::string unified_diff(const std::string& before, const std::string& after, const std::string& before_name,
                         const std::string& after_name) {
    if (before == after) {
        return "";
    }
    const std::vector<Step> all = steps(lines_of(before), lines_of(after));
    std::string text = "--- " + before_name + "\n+++ " + after_name + "\n";
    std::size_t old_line = 1;
    std::size_t new_line = 1;
    std::size_t i = 0;
    while (i < all.size()) {
        if (all[i].mark == ' ') {
            ++old_line;
            ++new_line;
            ++i;
            continue;
        }
        // A hunk: back by the context, on until twice the context passes without a change.
        const std::size_t lead = std::min(context, i);
        std::size_t end = i;
        for (std::size_t k = i; k < all.size() && k <= end + 2 * context; ++k) {
            end = all[k].mark == ' ' ? end : k;
        }
        const std::size_t stop = std::min(all.size(), end + 1 + context);
        std::size_t old_count = 0;
        std::size_t new_count = 0;
        std::string hunk;
        for (std::size_t k = i - lead; k < stop; ++k) {
            old_count += all[k].mark != '+' ? 1 : 0;
            new_count += all[k].mark != '-' ? 1 : 0;
            hunk += all[k].mark + all[k].text + "\n";
        }
        text += "@@ -" + hunk_range(old_line - lead, old_count) + " +" +
                hunk_range(new_line - lead, new_count) + " @@\n" + hunk;
        old_line += old_count - lead;
        new_line += new_count - lead;
        i = stop;
    }
    return text;
}

}  // namespace glslgen
