#pragma once

// The page that says what each table holds, how far it is off, and what it costs: measured, then written.

#include <filesystem>
#include <string>
#include <vector>

namespace bake_tables {

/// Measures tables on this machine, for Earth, and writes the page. Of a page that is there, sections of
/// tables other than `names` are kept; without names all are measured. Needs a current context of OpenGL;
/// `renderer` is its name.
void write_contract(const std::filesystem::path& path, const std::string& renderer,
                    const std::vector<std::string>& names);

/// Throws support::Error unless the page has a section for every table there is, and no other.
void check_contract(const std::filesystem::path& path);

}  // namespace bake_tables
