#pragma once

// The page that says what each table holds, how far it is off, and what it
// costs: measured, then written.

#include <filesystem>
#include <string>

namespace bake_tables {

/// Measures every table on this machine, for Earth, and writes the page. Needs
/// a current context of OpenGL; `renderer` is its name.
void write_contract(const std::filesystem::path& path, const std::string& renderer);

/// Throws support::Error unless the page has a section for every table there
/// is, and no other.
void check_contract(const std::filesystem::path& path);

}  // namespace bake_tables
