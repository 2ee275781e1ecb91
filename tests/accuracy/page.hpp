#pragma once

#include <string>

namespace float_error {

/// The page with its last section, from the marker on, replaced by `section`; appended where there is no
/// marker.
std::string with_section(const std::string& page, const std::string& section);

/// The section of a page, or nothing.
std::string section_of(const std::string& page);

/// Which compiler made the figures; a line of the section that may differ.
std::string machine_line();

/// What keeps two sections from saying the same, in one line; nothing where they do. Another maths library
/// moves a worst case by less than half of it.
std::string difference(const std::string& committed, const std::string& measured);

}  // namespace float_error
