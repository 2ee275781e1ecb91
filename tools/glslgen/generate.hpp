#pragma once

#include <map>
#include <string>
#include <vector>

#include "reader.hpp"
#include "refusal.hpp"

namespace glslgen {

struct Generated {
    std::vector<Refusal> refusals;
    std::map<std::string, std::string> files;  ///< path below the output folder, text; empty after a refusal
    std::map<std::string, std::string> sources;  ///< path below the output folder, header it comes from
    std::string root_file;                       ///< GLSL of the root header alone
};

/// The whole way from a header to the text of its GLSL and of all it includes.
Generated generate(const ReadOptions& options);

}  // namespace glslgen
