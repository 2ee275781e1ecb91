// What each function and method costs on a GPU, from Mesa's compiler, without a GPU.
#include <glslang/build_info.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "flags.hpp"
#include "jobs.hpp"
#include "radv.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "table.hpp"
#include "variants.hpp"

namespace shader_cost {
namespace {

struct Options {
    std::string family = "navi21";
    std::filesystem::path glsl = SHADER_COST_GLSL_DIR;
    std::filesystem::path baselines = SHADER_COST_BASELINES_DIR;
    std::filesystem::path results = SHADER_COST_RESULTS;
    std::string method;
    bool write = false;
    bool check = false;
    bool check_listing = false;
    bool check_flags = false;
};

std::vector<Row> measure_all(const Pricing& pricing, const std::vector<Job>& jobs) {
    const bool progress = isatty(STDERR_FILENO) != 0;
    std::vector<Row> rows;
    for (const Job& job : jobs) {
        if (progress) {
            std::cerr << "\r\033[K" << rows.size() + 1 << " of " << jobs.size() << ": " << job.method << " "
                      << job.setting << std::flush;
        }
        rows.push_back(pricing.measure(job));
    }
    if (progress) {
        std::cerr << "\r\033[K";
    }
    return rows;
}

std::vector<Job> chosen_jobs(const Library& library, const Library& baselines, const Options& options) {
    std::vector<Job> out = library_jobs(library);
    if (!options.check_flags) {
        const std::vector<Job> others = baseline_jobs(baselines);
        out.insert(out.end(), others.begin(), others.end());
    }
    const auto shows_flags = [&](const Job& job) {  // at one setting
        const support::Function& function = *library.manifest.function(job.method);
        return !function.flags.empty() &&
               job.setting == bench::settings(library.manifest, function).front().setting;
    };
    const auto other = [&](const Job& job) {
        return (!options.method.empty() && job.method != options.method) ||
               (options.check_flags && !shows_flags(job));
    };
    out.erase(std::remove_if(out.begin(), out.end(), other), out.end());
    if (out.empty()) {
        throw support::Error("no method is called '" + options.method +
                             "'; without --method every method is measured");
    }
    return out;
}

/// Prints what is wrong; the exit status.
int report(const std::vector<std::string>& problems, const std::string& advice) {
    for (const std::string& problem : problems) {
        std::cout << "FAILED: " << problem << "\n";
    }
    if (!problems.empty()) {
        std::cout << advice << "\n";
    }
    return problems.empty() ? 0 : 1;
}

const char* const measure_anew = "If that is meant, measure anew: shader_cost --write";

int check_listing(const std::vector<Job>& jobs, const Table& recorded) {
    std::vector<Row> rows;
    for (const Job& job : jobs) {
        rows.push_back({job.method, job.setting, job.flags, {}, ""});
    }
    return report(differences(recorded.rows, rows, true), measure_anew);
}

int run(const Options& options) {
    if ((options.write || options.check || options.check_listing) && !options.method.empty()) {
        throw support::Error(
            "--write and the checks of the whole table need every method; leave out --method");
    }
    const Library library{support::read_manifest(options.glsl / "manifest.json"),
                          {options.glsl, SHADER_COST_TABLES_DIR}};
    const Library baselines{support::read_manifest(options.baselines / "manifest.json"), {options.baselines}};
    const std::vector<Job> jobs = chosen_jobs(library, baselines, options);
    const auto recorded = [&] {
        return read_csv(support::read_file(options.results), options.results.string());
    };
    if (options.check_listing) {
        return check_listing(jobs, recorded());
    }

    const Radv radv(options.family);
    const std::string made_by = options.family + ", " + radv.driver() + " (RADV), glslang " +
                                std::to_string(GLSLANG_VERSION_MAJOR) + "." +
                                std::to_string(GLSLANG_VERSION_MINOR) + "; written by shader_cost --write";
    if (options.check && recorded().made_by != made_by) {
        std::cout << "skipped: the table is of " << recorded().made_by << "\nand this would be of " << made_by
                  << "\n";
        return support::skipped;
    }
    const std::vector<Row> rows = measure_all(Pricing(radv), jobs);
    std::cout << made_by << "\n\n";
    print(std::cout, rows);
    if (options.write) {
        support::write_file(options.results, csv(rows, made_by));
        std::cout << "\nwrote " << options.results.string() << "\n";
    }
    if (options.check_flags) {
        return report(flags_that_save_nothing(library, rows), "A term that is off must cost nothing.");
    }
    return options.check ? report(differences(recorded().rows, rows, false), measure_anew) : 0;
}

/// A machine without RADV is a failure in CI, and where the user says so.
int run_or_skip(const Options& options) {
    try {
        return run(options);
    } catch (const NoRadv& e) {
        if (support::environment_asks({"CI", "AIRLIGHT_REQUIRE_RADV"})) {
            throw;
        }
        std::cout << "skipped: " << e.what() << "\n(set AIRLIGHT_REQUIRE_RADV=1 to make this a failure)\n";
        return support::skipped;
    }
}

}  // namespace
}  // namespace shader_cost

int main(int argc, char** argv) {
    shader_cost::Options options;
    CLI::App app(
        "Compiles every function of the generated GLSL for an AMD GPU that need not be there, by Mesa's "
        "RADV, and\n"
        "prints what each costs: instructions, registers, cycles. bench/README.md says how to read it.",
        "shader_cost");
    support::add_value(app, "--family", "<name>", options.family,
                       "of the GPU, as RADV_FORCE_FAMILY takes it (default navi21)");
    support::add_value(app, "--method", "<name>", options.method, "this function only");
    support::add_value(app, "--glsl", "<folder>", options.glsl,
                       "the generated GLSL and its manifest.json (default: that of the source tree)");
    support::add_value(app, "--baselines", "<folder>", options.baselines,
                       "the GLSL of study/baselines and its manifest.json (default: that of the build)");
    support::add_value(app, "--results", "<file>", options.results,
                       "the table to write or to compare with (default: results.csv of the source tree)");
    support::add_switch(app, "--write", options.write, "write the table");
    support::add_switch(app, "--check", options.check,
                        "compare with the table and name what changed; skips when it is of another Mesa");
    support::add_switch(app, "--check-listing", options.check_listing,
                        "only check that the table lists every function; needs no RADV");
    support::add_switch(app, "--check-flags", options.check_flags,
                        "check that every flag that is off saves instructions");
    app.footer("Exit status: 0 all is well, 1 something differs or failed, 2 wrong use, 77 no RADV here.");
    return support::guarded_main(app, argc, argv, [&] { return shader_cost::run_or_skip(options); });
}
