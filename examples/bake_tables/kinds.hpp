#pragma once

// The tables that can be baked: what each holds, and how CPU and GPU fill it.

#include <functional>
#include <string>
#include <vector>

#include "gpu_baker.hpp"
#include "rows.hpp"
#include "support/gl_table.hpp"
#include "support/presets.hpp"
#include "support/table_file.hpp"

namespace bake_tables {

/// What a user chooses.
struct Request {
    support::Preset preset;
    support::TableSize size;
    int orders;  ///< of scattering, for the tables that are made order by order
};

/// The numbers of a table, channels side by side, x fastest.
using Numbers = std::vector<float>;

struct Kind {
    std::string name;  ///< on the command line, and of the file
    std::string what;  ///< one line
    support::TableSize size;
    bool has_orders;
    std::string mapping;
    std::string payload;
    std::string units;
    std::vector<std::string> channels;
    bool may_be_negative;
    support::TableSize small_size;                                  ///< for tests, where not every size does
    std::function<std::string(const support::TableSize&)> refuses;  ///< why not this size, or nothing
    std::function<Numbers(const Request&, const Rows&)> on_cpu;
    std::function<std::vector<double>(const Request&, const Rows&)> in_double;
    std::function<Numbers(const Request&, GpuBaker&)> on_gpu;
};

const std::vector<Kind>& kinds();

/// Throws support::Error with the names that there are.
const Kind& kind_named(const std::string& name);

/// What goes into the file's header, and what a reader asks for.
support::TableDescription describe(const Kind& kind, const Request& request);

}  // namespace bake_tables
