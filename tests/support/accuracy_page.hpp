#pragma once

#include <string>

namespace airlight_test {

/// Where the section of docs/accuracy.md begins that tests/accuracy writes; it is the page's last.
inline constexpr const char* float_error_marker = "<!-- from here on by float_error -->";

/// That section of a page, or nothing.
inline std::string float_error_section(const std::string& page) {
    const std::size_t begin = page.find(float_error_marker);
    return begin == std::string::npos ? "" : page.substr(begin);
}

}  // namespace airlight_test
