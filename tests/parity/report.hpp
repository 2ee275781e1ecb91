#pragma once

// docs/accuracy.md.

#include <string>
#include <vector>

#include "builtins.hpp"
#include "compare.hpp"

namespace parity {

std::string accuracy_page(const std::vector<RowResult>& results, const BuiltinReport& builtins,
                          const Manifest& manifest, const Settings& settings, const std::string& driver);

}  // namespace parity
