#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace support {

/// GLSL with its #include lines replaced by the files they name.
struct ExpandedGlsl {
    std::string text;
    std::vector<std::string> names;  ///< of source string n of a #line directive
};

/// Replaces each line `#include "a/b.glsl"` by the file, looked for in `folders` in their order, each file
/// only the first time. #line directives keep line numbers and source numbers true in a driver's error log.
/// A file may start with #version; an included one must not. Throws Error when a file is missing.
ExpandedGlsl expand_includes(const std::filesystem::path& file,
                             const std::vector<std::filesystem::path>& folders);

/// The same for a text that is not a file; `name` stands for it in error logs.
ExpandedGlsl expand_includes(const std::string& text, const std::string& name,
                             const std::vector<std::filesystem::path>& folders);

}  // namespace support
