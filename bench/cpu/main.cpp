// Nanoseconds per call of every function, by Google Benchmark.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <string>

#include "batch.hpp"
#include "results_table.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/manifest.hpp"

namespace cpu_bench {
namespace {

const char* const help =
    "usage: cpu_bench [options]\n"
    "Times every function of the library on one core, in float and double, in batches of 1024 calls.\n"
    "  --table=<file>     write a Markdown page of the times; takes every benchmark that ran\n"
    "  --check-listing    only check that every function of the library has a benchmark\n"
    "  --help             this text\n"
    "and those of Google Benchmark, of which the most useful are:\n"
    "  --benchmark_filter=<regular expression>    such as '^transmittance/.*float'\n"
    "  --benchmark_min_time=<seconds>             for each benchmark (default 0.5)\n"
    "  --benchmark_repetitions=<number>           the table then has the least disturbed\n"
    "  --benchmark_list_tests  --benchmark_out=<file>  --benchmark_format=<console|json|csv>\n";

/// Takes `--name=value` (or `--name`, where the value is then empty) out of the arguments.
bool take_option(int& argc, char** argv, const std::string& name, std::string& value) {
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == name || argument.compare(0, name.size() + 1, name + "=") == 0) {
            value = argument == name ? "" : argument.substr(name.size() + 1);
            std::copy(argv + i + 1, argv + argc, argv + i);
            --argc;
            return true;
        }
    }
    return false;
}

/// Every function of the manifest must have been entered: what the build knows is what is timed.
int check_listing(const std::vector<std::string>& names) {
    int missing = 0;
    const support::Manifest manifest = support::read_manifest(CPU_BENCH_MANIFEST);
    for (const support::Function& function : manifest.functions) {
        for (const char* const scalar : {"/float", "/double"}) {
            const auto is_it = [&](const std::string& name) {
                return name.compare(0, function.name.size() + 1, function.name + "/") == 0 &&
                       name.compare(name.rfind('/'), std::string::npos, scalar) == 0;
            };
            if (std::none_of(names.begin(), names.end(), is_it)) {
                std::cout << "FAILED: '" << function.name << "' of " << function.header
                          << " has no benchmark in " << scalar + 1 << "; build anew\n";
                ++missing;
            }
        }
    }
    std::cout << manifest.functions.size() << " functions, " << names.size() << " benchmarks, " << missing
              << " missing\n";
    return missing == 0 ? 0 : 1;
}

int run(int argc, char** argv) {
    std::string nothing;
    if (take_option(argc, argv, "--help", nothing) || take_option(argc, argv, "-h", nothing)) {
        std::cout << help;
        return 0;
    }
    std::vector<std::string> names;
    add_float(names);
    add_double(names);
    if (take_option(argc, argv, "--check-listing", nothing)) {
        return check_listing(names);
    }
    std::string table;
    const bool wants_table = take_option(argc, argv, "--table", table);
    if (wants_table && table.empty()) {
        throw support::Error("--table needs a file: --table=results.md");
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    if (!wants_table) {
        return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 1;
    }
    CollectingReporter reporter;
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) {
        return 1;
    }
    support::write_file(table, reporter.page());
    std::cout << "wrote " << table << "\n";
    return 0;
}

}  // namespace
}  // namespace cpu_bench

int main(int argc, char** argv) {
    try {
        return cpu_bench::run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << argv[0] << ": " << e.what() << "\n";
        return 1;
    }
}
