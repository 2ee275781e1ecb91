#pragma once

#include <string>

// What the command lines of both scenes check alike. Each throws support::Error.

namespace deferred {

[[noreturn]] void refuse_option(const std::string& what);

void require_range(const std::string& option, double value, double least, double most);

/// "640x360".
void parse_size(const std::string& option, const std::string& text, int& width, int& height);

/// A factor in its range; `text` is not "auto".
double parse_exposure(const std::string& text);

}  // namespace deferred
