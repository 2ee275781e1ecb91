#include "flags.hpp"

#include <algorithm>
#include <utility>

#include "table.hpp"
#include "variants.hpp"

namespace shader_cost {
namespace {

/// Functions to which a flag comes only through a function of which they use another part. There the counts
/// must be equal: the compiler removes what is not used.
const std::vector<std::pair<std::string, std::string>> untouched = {
    {"layer_column", "mie"},   // takes the ozone alone of relative_density
    {"ozone_column", "mie"},   // likewise
    {"slant_texel", "ozone"},  // takes the scale heights alone of layers_of
};

const Row* find(const std::vector<Row>& rows, const Row& like, const std::string& flags) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.method == like.method && row.setting == like.setting && row.flags == flags;
    });
    return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> flags_that_save_nothing(const Library& library, const std::vector<Row>& rows) {
    std::vector<std::string> out;
    for (const support::Flag& flag : library.manifest.flags) {
        const std::string off = bench::off_value(flag);
        if (off.empty()) {
            continue;
        }
        for (const Row& on : rows) {
            const Row* const without =
                on.flags == "default" ? find(rows, on, bench::flag_text(flag, off)) : nullptr;
            if (without == nullptr) {
                continue;
            }
            const double difference = on.price.counts.instructions - without->price.counts.instructions;
            const bool equal_is_right = std::find(untouched.begin(), untouched.end(),
                                                  std::make_pair(on.method, flag.name)) != untouched.end();
            if (equal_is_right ? difference != 0 : difference <= 0) {
                out.push_back(
                    key(*without) + ": " + std::to_string(long(without->price.counts.instructions)) +
                    " instructions, with the term " + std::to_string(long(on.price.counts.instructions)) +
                    (equal_is_right ? "; must be equal, the term is not part of it"
                                    : "; must be fewer, or the function be named in flags.cpp"));
            }
        }
    }
    return out;
}

}  // namespace shader_cost
