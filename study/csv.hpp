#pragma once

// The CSV files that the study writes, and reads to write its pages.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace study {

/// A table with named columns and lines of comment above.
struct Csv {
    std::vector<std::string> comments;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;

    /// The cells of a row by column. Throws support::Error when the table has no such column.
    const std::string& cell(std::size_t row, const std::string& column) const;
    double number(std::size_t row, const std::string& column) const;
    /// The first row in which every given cell is as given, or rows.size().
    std::size_t find(const std::map<std::string, std::string>& cells) const;
};

/// Throws support::Error when the file is not there or a row has more or fewer cells than there are columns.
Csv read_csv(const std::filesystem::path& path);

void write_csv(const std::filesystem::path& path, const Csv& csv);

/// Five digits, which is more than any figure here is worth.
std::string figure(double number);

}  // namespace study
