#pragma once

#include <string>
#include <vector>

#include "header.hpp"
#include "refusal.hpp"

namespace glslgen {

struct ReadOptions {
    std::string root;                          ///< header to start from: the umbrella, or one header
    std::vector<std::string> include_folders;  ///< what lies below these belongs to the project
    std::vector<std::string> system_folders;   ///< searched too, never translated
};

struct ReadResult {
    std::vector<Header> headers;      ///< a header stands after all that it includes; the root is last
    std::vector<Refusal> complaints;  ///< the compiler's errors
};

/// Compiles the root header with libclang and describes every project header it reaches.
/// Throws Failure when the root cannot be read.
ReadResult read_headers(const ReadOptions& options);

}  // namespace glslgen
