#pragma once

#include <string>
#include <vector>

#include "header.hpp"
#include "layout.hpp"
#include "model.hpp"
#include "refusal.hpp"

namespace glslgen {

/// One declaration in GLSL, with the comments that belong to it.
struct Item {
    std::vector<Line> lines;
    bool blank_before = true;
};

/// One header in GLSL.
struct Translation {
    std::string header;                 ///< "ray_sphere.hpp"
    std::string stem;                   ///< "ray_sphere"
    std::string shown;                  ///< "include/airlight/ray_sphere.hpp"
    std::vector<std::string> includes;  ///< names of included headers, in order
    std::vector<Line> preface;          ///< the comment at the top of the header
    std::vector<Item> items;
    std::vector<std::string> hooks;  ///< that its functions take

    bool empty() const {
        return items.empty();
    }
};

/// Reads one header's declarations into the program and returns its GLSL. What leaves the subset is added
/// to `refusals`, one per declaration.
Translation translate(const Header& header, Program& program, std::vector<Refusal>& refusals);

}  // namespace glslgen
