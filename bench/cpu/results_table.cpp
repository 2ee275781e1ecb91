#include "results_table.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "batch.hpp"
#include "support/machine.hpp"

namespace cpu_bench {
namespace {

/// Three significant digits, no exponent.
std::string short_text(double number) {
    if (number <= 0) {
        return "";
    }
    const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(number))));
    std::ostringstream out;
    out << std::fixed << std::setprecision(decimals) << number;
    return out.str();
}

}  // namespace

bool CollectingReporter::ReportContext(const Context& context) {
    std::ostringstream out;
    out << support::processor_name() << ", " << context.cpu_info.num_cpus << " cores at "
        << std::lround(context.cpu_info.cycles_per_second / 1e6) << " MHz; " << CPU_BENCH_COMPILER;
    machine_ = out.str();
    return ConsoleReporter::ReportContext(context);
}

void CollectingReporter::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.error_occurred || run.run_type != Run::RT_Iteration) {
            continue;
        }
        const std::string name = run.run_name.function_name;
        const std::size_t slash = name.rfind('/');
        const std::string row = name.substr(0, slash);
        if (rows_.count(row) == 0) {
            order_.push_back(row);
        }
        const double per_call = run.GetAdjustedCPUTime() / batch_size;
        Nanoseconds& times = rows_[row];
        double& time = name.substr(slash + 1) == "float" ? times.in_float : times.in_double;
        time = time == 0 ? per_call : std::min(time, per_call);  // of repetitions the one least disturbed
    }
    ConsoleReporter::ReportRuns(runs);
}

std::string CollectingReporter::page() const {
    std::ostringstream out;
    out << "# Nanoseconds per call\n\nWritten by `cpu_bench --table=<file>`; do not edit. One thread, "
           "batches of "
        << batch_size << " calls.\n\nMachine: " << machine_ << ".\n\n"
        << "| function, steps or nodes, flags | float | double |\n|---|---:|---:|\n";
    for (const std::string& row : order_) {
        const Nanoseconds& times = rows_.at(row);
        out << "| `" << row << "` | " << short_text(times.in_float) << " | " << short_text(times.in_double)
            << " |\n";
    }
    return out.str();
}

}  // namespace cpu_bench
