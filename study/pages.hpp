#pragma once

// The pages that show the study's figures: docs/trade.md and a table of README.md. Their text is written
// by hand, the figures stand between markers and are filled in.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "csv.hpp"

namespace study {

/// The tables that the pages are made from.
struct Tables {
    Csv errors;
    Csv cost;
    Csv classes;
    Csv gpu;  ///< without rows where there is none
};

/// Reads the folder's tables, and the GPU's where the file is.
Tables read_tables(const std::filesystem::path& results, const std::filesystem::path& gpu);

/// What belongs between the markers, by the marker's name.
std::map<std::string, std::string> blocks(const Tables& tables);

/// The text with each block between `<!-- study: name -->` and `<!-- study: end -->` replaced. Throws
/// support::Error for a marker without end or a name that is no block.
std::string filled(const std::string& text, const std::map<std::string, std::string>& blocks);

/// A share as per cent with two digits that count: 0.000314 is 0.031.
std::string percent(double share);

}  // namespace study
