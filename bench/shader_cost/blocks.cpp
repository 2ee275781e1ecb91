#include "blocks.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <sstream>

#include "support/error.hpp"

namespace shader_cost {
namespace {

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// The number in a line "BB12" or "BB12:", -1 in any other line.
int block_number(const std::string& line) {
    const bool is_label = line.size() > 2 && line.compare(0, 2, "BB") == 0 &&
                          line.find_first_not_of("0123456789:", 2) == std::string::npos;
    return is_label ? std::atoi(line.c_str() + 2) : -1;
}

/// Blocks without counts, from the notes on their kinds: "loop-header" and "loop-exit" say where a loop
/// begins and ends, "branch" and "merge" where a condition does.
std::vector<Block> empty_blocks(const std::string& ir) {
    std::vector<Block> out;
    std::vector<int> conditions = {0};  // open ones: outside of loops, in the first loop, in one within it
    std::istringstream lines(ir);
    for (std::string line; std::getline(lines, line);) {
        const int number = block_number(line);
        if (number < 0) {
            continue;
        }
        std::string kind;
        std::getline(lines, kind);
        kind = kind.substr(std::min(kind.find("kind:"), kind.size()));
        if (static_cast<std::size_t>(number) != out.size() || kind.empty()) {
            throw support::Error(
                "the blocks of this Mesa's ACO IR are written in a way that is not understood");
        }
        if (contains(kind, "loop-header")) {
            conditions.push_back(0);
        }
        if (contains(kind, "loop-exit") && conditions.size() > 1) {
            conditions.pop_back();
        }
        if (contains(kind, "merge")) {
            --conditions.back();
        }
        out.push_back({static_cast<int>(conditions.size()) - 1,
                       std::accumulate(conditions.begin(), conditions.end(), 0),
                       conditions.back() > 0,
                       {}});
        if (contains(kind, "branch")) {
            ++conditions.back();
        }
    }
    return out;
}

/// Counts by the names that the disassembler prints, one instruction a line.
void count_instructions(const std::string& assembly, std::vector<Block>& blocks) {
    static const char* const quarter_rate[] = {"v_exp_f32", "v_log_f32",  "v_rcp_f32", "v_rcp_iflag_f32",
                                               "v_rsq_f32", "v_sqrt_f32", "v_sin_f32", "v_cos_f32"};
    std::size_t current = 0;
    std::istringstream lines(assembly);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = line.find_first_of("abcdefghijklmnopqrstuvwxyz");
        const int number = block_number(line);
        if (number >= 0) {
            current = static_cast<std::size_t>(number);
        }
        // An instruction is indented and its name has an underscore: v_add_f32, s_endpgm, buffer_load_dword.
        if (number >= 0 || begin == std::string::npos || begin == 0 ||
            line.find('_', begin) > line.find_first_of(" \t", begin)) {
            continue;
        }
        Counts& counts = blocks.at(current).counts;
        counts.instructions += 1;
        if (line.compare(begin, 2, "v_") != 0) {
            continue;
        }
        counts.vector += 1;
        for (const char* const name : quarter_rate) {
            if (line.compare(begin, std::strlen(name), name) == 0) {
                counts.transcendental += 1;
                break;
            }
        }
    }
}

}  // namespace

std::vector<Block> read_blocks(const std::string& ir, const std::string& assembly) {
    std::vector<Block> out = empty_blocks(ir);
    count_instructions(assembly, out);
    return out;
}

}  // namespace shader_cost
