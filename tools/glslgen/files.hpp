#pragma once

#include <optional>
#include <string>

namespace glslgen {

/// Text of a file, or nothing where there is none.
std::optional<std::string> read_text(const std::string& path);

/// Writes through a temporary file that is renamed; a file that holds the text already is not touched.
/// Returns whether it wrote. Throws Failure.
bool write_text(const std::string& path, const std::string& text);

}  // namespace glslgen
