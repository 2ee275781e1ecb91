#pragma once

// The price list as a file of comma-separated values, and as text to read.

#include <iosfwd>
#include <string>
#include <vector>

#include "cost.hpp"

namespace shader_cost {

/// `made_by` is the comment of the first line: what the numbers depend on.
std::string csv(const std::vector<Row>& rows, const std::string& made_by);

/// The price list that csv() wrote. Throws support::Error when it is none.
struct Table {
    std::string made_by;
    std::vector<Row> rows;
};
Table read_csv(const std::string& text, const std::string& name);

/// Columns under their names.
void print(std::ostream& out, const std::vector<Row>& rows);

/// A row's method, setting and flags.
std::string key(const Row& row);

/// One line for each row that is missing, new, or has other numbers. With `listing_only`, numbers are not
/// compared.
std::vector<std::string> differences(const std::vector<Row>& recorded, const std::vector<Row>& measured,
                                     bool listing_only);

}  // namespace shader_cost
