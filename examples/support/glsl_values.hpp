#pragma once

// GLSL text that moves values between flat arrays of floats and the types of a manifest.

#include <cstddef>
#include <string>

#include "support/manifest.hpp"

namespace support {

/// The name of a manifest's type in GLSL.
std::string glsl_type(const Manifest& manifest, const std::string& type);

/// An expression for a value of `type` from the floats fetch(base + at), and moves `at` on. The shader
/// defines `fetch` and `base`.
std::string construct(const Manifest& manifest, const std::string& type, std::size_t& at);

/// Statements that write `value` of `type` to out_data[out_base + at], and moves `at` on. `qualifier` stands
/// before each number's declaration: "" or "precise ".
std::string store(const Manifest& manifest, const std::string& type, const std::string& value,
                  const std::string& qualifier, std::size_t& at);

}  // namespace support
