#include "jobs.hpp"

#include <set>
#include <string>
#include <utility>

#include "pieces.hpp"
#include "support/error.hpp"
#include "variants.hpp"

namespace shader_cost {
namespace {

/// Loops over the pieces of a ray, around the loop over the nodes: legs times cuts of single_scattering.
const std::vector<int> passes_over_pieces = {2, 4};

bool has_pieces(const support::Function& function) {
    return function.name == "single_scattering";
}

void add(const Library& library, const support::Function& function, const std::string& method,
         const bench::Variant& variant, int degree, std::vector<Job>& out) {
    Job job{method,
            variant.setting,
            variant.flags,
            variant.counts,
            [&library, &function, values = variant.values](const std::vector<int>& counts) {
                return function_shader(library, function, values, counts);
            },
            degree,
            {},
            0};
    if (has_pieces(function)) {
        job.piece_passes = passes_over_pieces;
        job.pieces = mean_pieces(variant.flags);
    }
    out.push_back(std::move(job));
}

/// Every setting, and with each flag at each other value: the first setting, of single_scattering each of
/// them, because that is the choice that users have.
void add_all(const Library& library, const support::Function& function, const std::string& method,
             const std::vector<bench::Variant>& settings, int degree, std::vector<Job>& out) {
    for (const bench::Variant& setting : settings) {
        add(library, function, method, setting, degree, out);
    }
    for (const bench::Variant& setting : settings) {
        if (has_pieces(function) || &setting == &settings.front()) {
            for (const bench::Variant& variant : bench::flag_variants(library.manifest, function, setting)) {
                add(library, function, method, variant, degree, out);
            }
        }
    }
}

struct Baseline {
    const char* name;
    std::vector<std::vector<int>> counts;
    int degree = 1;
};

/// At the settings that the study measures, first the one that its author or its users give.
const std::vector<Baseline> baselines_and_settings = {
    {"leenman", {{16, 6}, {12, 4}, {32, 8}, {64, 16}, {256, 64}}},
    {"cs562", {{21}, {31}, {101}, {801}}},  // samples, one more than steps
    {"hillaire", {{30}, {15}, {60}, {240}}},
    {"schueler", {{64}, {16}, {256}}},
    {"hdrp", {{64}, {16}, {256}}},
    {"double_loop", {{64}, {8}, {16}, {32}}, 2},
};

/// Pieces and looks of light_lost_in_shadow, first the deferred renderer's.
const std::vector<std::vector<int>> shaft_counts = {{12, 8}, {8, 4}, {8, 8}, {16, 16}};

std::vector<bench::Variant> settings_of(const std::vector<std::vector<int>>& all) {
    std::vector<bench::Variant> settings;
    for (const std::vector<int>& counts : all) {
        std::string text;
        for (const int count : counts) {
            text += (text.empty() ? "" : "x") + std::to_string(count);
        }
        settings.push_back({text, "default", {}, counts});
    }
    return settings;
}

/// What reads a table for every pixel, with the deferred renderer's hooks.
struct TableMethod {
    const char* function;
    const char* table;   ///< in the table of prices
    const char* tables;  ///< in examples/deferred/shaders/tables.glsl
};

const std::vector<TableMethod> table_methods = {
    {"diffuse_scattering", "table=hillaire", "TABLES_HILLAIRE"},
    {"diffuse_scattering", "table=diffuse", "TABLES_DIFFUSE"},
    {"scattering_of_table", "table=inscatter3d", "TABLES_INSCATTER3D"},
    {"scattering_of_table", "table=bruneton", "TABLES_BRUNETON"},
};

Job table_job(const Library& library, const TableMethod& method, const bench::Variant& variant) {
    const support::Function& function = *library.manifest.function(method.function);
    Job job{method.function,
            variant.setting,
            method.table,
            {},
            [&library, &function, tables = std::string(method.tables),
             values = variant.values](const std::vector<int>& counts) {
                return function_shader(library, function, values, counts, tables);
            },
            1,
            {},
            0};
    if (function.name == "diffuse_scattering") {
        job.piece_passes = {2};  // the sides of the closest approach
        job.pieces = mean_sides();
    }
    return job;
}

}  // namespace

std::vector<Job> library_jobs(const Library& library) {
    // What fills tables runs once, not for every pixel. all_scattering and what else calls single_scattering
    // and more costs their sum, and takes many minutes to compile.
    static const std::set<std::string> unmeasured = {
        "gathered_light.hpp",      "hillaire_table.hpp", "scattering_orders.hpp", "scattering_of_table.hpp",
        "multiple_scattering.hpp", "sky_view_table.hpp", "froxel_table.hpp",      "sky.hpp",
        "aerial_perspective.hpp"};
    std::vector<Job> out;
    for (const support::Function& function : library.manifest.functions) {
        if (unmeasured.count(function.header) != 0) {
            continue;
        }
        add_all(library, function, function.name,
                function.name == "light_lost_in_shadow" ? settings_of(shaft_counts)
                                                        : bench::settings(library.manifest, function),
                1, out);
    }
    for (const TableMethod& method : table_methods) {
        const support::Function& function = *library.manifest.function(method.function);
        for (const bench::Variant& setting : bench::settings(library.manifest, function)) {
            out.push_back(table_job(library, method, setting));
        }
    }
    return out;
}

std::vector<Job> baseline_jobs(const Library& baselines) {
    std::vector<Job> out;
    for (const Baseline& baseline : baselines_and_settings) {
        const support::Function* const function =
            baselines.manifest.function(std::string("baseline::") + baseline.name);
        if (function == nullptr) {
            throw support::Error(std::string("study/baselines has no '") + baseline.name +
                                 "' any more; take it out of bench/shader_cost/jobs.cpp");
        }
        add_all(baselines, *function, baseline.name, settings_of(baseline.counts), baseline.degree, out);
    }
    return out;
}

}  // namespace shader_cost
