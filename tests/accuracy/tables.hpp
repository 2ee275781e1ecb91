#pragma once

// The tables of float's error, as text for docs/accuracy.md.

#include <cstdio>
#include <string>

namespace float_error {

/// A heading, what the figures are, and a table of them in Markdown.
std::string column_table();
std::string view_tables();

/// An error with two digits; 0 where there is none.
inline std::string figure(double error) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", error);
    return error == 0 ? "0" : text;
}

/// A length with its unit: 10 m, 30 km.
inline std::string length_text(double metres) {
    char text[32];
    if (metres < 1e3) {
        std::snprintf(text, sizeof text, "%.3g m", metres);
    } else if (metres < 1e9) {
        std::snprintf(text, sizeof text, "%.0f km", metres / 1e3);
    } else {
        std::snprintf(text, sizeof text, "%.0e km", metres / 1e3);
    }
    return text;
}

}  // namespace float_error
