#pragma once

#include <string>
#include <vector>

namespace shader_cost {

/// Machine instructions.
struct Counts {
    double instructions = 0;
    double vector = 0;          ///< of these, those that the vector unit executes, one lane a ray
    double transcendental = 0;  ///< of these, exp, log, 1/x, sqrt, 1/sqrt, sin, cos: a quarter of the rate
};

/// Code without a jump into or out of it.
struct Block {
    int loops = 0;             ///< how many loops it lies in
    int conditions = 0;        ///< how many divergent branches it lies in
    bool conditional = false;  ///< whether one of these lies within the innermost loop
    Counts counts;
};

/// The blocks of a shader in their order, and what is in them. `ir` is Mesa's "ACO IR", which notes the kind
/// of each block, `assembly` its "Assembly". Throws support::Error when they are written in another way.
std::vector<Block> read_blocks(const std::string& ir, const std::string& assembly);

}  // namespace shader_cost
