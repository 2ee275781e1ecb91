#pragma once

#include <map>
#include <string>
#include <vector>

#include "translate.hpp"

namespace glslgen {

/// Path of a header's GLSL below the output folder: "airlight/ray_sphere.glsl".
std::string file_of(const std::string& stem);

/// The GLSL file of one header. `all` holds every translation, to follow includes of headers that have no
/// GLSL of their own.
std::string single_file(const Translation& translation, const std::vector<Translation>& all,
                        const Program& program);

/// Every header in one file without #include.
std::string whole_library(const std::vector<Translation>& all, const Program& program);

/// Everything that is generated: path below the output folder, and text.
std::map<std::string, std::string> generated_files(const std::vector<Translation>& all,
                                                   const Program& program);

/// First words of every generated GLSL file.
extern const char* const generated_mark;

}  // namespace glslgen
