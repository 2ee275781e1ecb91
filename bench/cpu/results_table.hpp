#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace cpu_bench {

/// Prints as Google Benchmark does, and keeps the times.
class CollectingReporter : public benchmark::ConsoleReporter {
  public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;

    /// A Markdown page: the machine, and for each function the nanoseconds of a call in float and double.
    std::string page() const;

  private:
    struct Nanoseconds {
        double in_float = 0;
        double in_double = 0;
    };
    std::string machine_;
    std::vector<std::string> order_;
    std::map<std::string, Nanoseconds> rows_;  ///< by name without the scalar type
};

}  // namespace cpu_bench
