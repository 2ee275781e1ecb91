#pragma once

#include <string>
#include <vector>

#include "site.hpp"

namespace glslgen {

// Each adds one declaration to the program and returns its GLSL without the comments around it. All throw
// Refused, and FollowsFromRefusal where the cause was refused before.

std::vector<Line> read_constant(const Site& site);
std::vector<Line> read_choice(const Site& site);
std::vector<Line> read_scene(const Site& site);
std::vector<Line> read_structure(const Site& site);
std::vector<Line> read_function(const Site& site);

/// A hook's functor. It has no GLSL of its own: its macro stands in the files that use the hook.
void read_functor(const Site& site);

/// The parameters of a hook's macro: those of the functor that are no structures.
std::vector<std::string> macro_parameters(const Functor& functor);

/// The default of a hook's macro, guarded, with the functor's comment.
std::vector<Line> hook_lines(const Program& program, const std::string& hook);

}  // namespace glslgen
