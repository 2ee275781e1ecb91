#include "csv.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "support/error.hpp"
#include "support/files.hpp"

namespace study {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

std::string joined(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& cell : cells) {
        line += (line.empty() ? "" : ",") + cell;
    }
    return line + "\n";
}

}  // namespace

const std::string& Csv::cell(std::size_t row, const std::string& column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) {
        throw support::Error("a table of the study has no column '" + column + "'; write it again");
    }
    return rows.at(row).at(static_cast<std::size_t>(found - columns.begin()));
}

double Csv::number(std::size_t row, const std::string& column) const {
    const std::string& text = cell(row, column);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') {
        throw support::Error("'" + text + "' in column '" + column +
                             "' of a table of the study is no number");
    }
    return value;
}

std::size_t Csv::find(const std::map<std::string, std::string>& cells) const {
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (std::all_of(cells.begin(), cells.end(),
                        [&](const auto& wanted) { return cell(row, wanted.first) == wanted.second; })) {
            return row;
        }
    }
    return rows.size();
}

Csv read_csv(const std::filesystem::path& path) {
    std::istringstream lines(support::read_file(path));
    Csv out;
    std::string line;
    while (std::getline(lines, line)) {
        if (line.rfind("# ", 0) == 0) {
            out.comments.push_back(line.substr(2));
        } else if (out.columns.empty()) {
            out.columns = split(line);
        } else {
            out.rows.push_back(split(line));
            if (out.rows.back().size() != out.columns.size()) {
                throw support::Error(path.string() + ": '" + line + "' has not " +
                                     std::to_string(out.columns.size()) + " cells");
            }
        }
    }
    return out;
}

void write_csv(const std::filesystem::path& path, const Csv& csv) {
    std::string text;
    for (const std::string& comment : csv.comments) {
        text += "# " + comment + "\n";
    }
    text += joined(csv.columns);
    for (const std::vector<std::string>& row : csv.rows) {
        text += joined(row);
    }
    support::write_file(path, text);
}

std::string figure(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", number);
    return text;
}

}  // namespace study
