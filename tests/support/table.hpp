#pragma once

// Reads the reference tables of tests/data: comma-separated text, comment lines with #, one line of
// column names. Inputs are numbers that float holds exactly, so that all three types see the same ones.

#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace airlight_test {

class Row {
  public:
    Row(std::map<std::string, std::string> cells, std::string where)
        : cells_(std::move(cells)), where_(std::move(where)) {}

    /// An input; throws when T does not hold it exactly.
    template <typename T>
    T input(const std::string& column) const {
        // The text is the shortest that names one double, so it is read as a double whatever T is.
        const double value = std::strtod(cell(column).c_str(), nullptr);
        if (static_cast<double>(static_cast<T>(value)) != value) {
            throw std::runtime_error(where_ + ": " + column + " is not exact in this type");
        }
        return static_cast<T>(value);
    }

    /// A result, 50 digits rounded to long double.
    long double expected(const std::string& column) const {
        char* end = nullptr;
        const std::string& text = cell(column);
        const long double value = std::strtold(text.c_str(), &end);
        if (text.empty() || *end != '\0') {
            throw std::runtime_error(where_ + ": " + column + " is not a number: '" + text + "'");
        }
        return value;
    }

    const std::string& text(const std::string& column) const {
        return cell(column);
    }

  private:
    const std::string& cell(const std::string& column) const {
        const auto found = cells_.find(column);
        if (found == cells_.end()) {
            throw std::runtime_error(where_ + ": no column named " + column);
        }
        return found->second;
    }

    std::map<std::string, std::string> cells_;
    std::string where_;
};

inline std::vector<std::string> split_cells(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

/// All rows of a table; throws with the path when it cannot be read, is empty or has a torn line.
inline std::vector<Row> read_table(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw std::runtime_error(path +
                                 ": cannot be opened; tables are written by tests/data/make_tables.py");
    }
    std::vector<std::string> names;
    std::vector<Row> rows;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        const std::vector<std::string> cells = split_cells(line);
        const std::string where = path + ":" + std::to_string(number);
        if (names.empty()) {
            names = cells;
            continue;
        }
        if (cells.size() != names.size()) {
            throw std::runtime_error(where + ": " + std::to_string(cells.size()) + " cells, expected " +
                                     std::to_string(names.size()));
        }
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; i < names.size(); ++i) {
            row[names[i]] = cells[i];
        }
        rows.emplace_back(std::move(row), where);
    }
    if (rows.empty()) {
        throw std::runtime_error(path + ": no rows");
    }
    return rows;
}

#ifdef AIRLIGHT_TEST_DATA
/// A table of tests/data by its name, without folder and ending.
inline std::vector<Row> reference(const std::string& name) {
    return read_table(std::string(AIRLIGHT_TEST_DATA "/") + name + ".csv");
}
#endif

}  // namespace airlight_test
