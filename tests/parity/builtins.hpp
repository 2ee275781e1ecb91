#pragma once

// What the driver's own exp, log, pow and sqrt are off by: measured first, because the tolerances of
// everything that calls them follow from it.

#include <cstdint>
#include <string>
#include <vector>

namespace parity {

/// One measured built-in, for the report.
struct BuiltinRow {
    std::string name;
    std::string range;  ///< of the arguments
    std::size_t inputs = 0;
    double max_relative = 0;   ///< against C++ double
    double max_absolute = 0;   ///< against C++ double
    double at_x = 0;           ///< where max_relative (max_absolute for log) was met
    double at_y = 0;           ///< pow only
    double specification = 0;  ///< largest multiple of what the GLSL specification allows
};

/// One operation or vector built-in compared with C++ float, bit by bit.
struct OperationRow {
    std::string glsl;
    std::string cpp;
    std::size_t inputs = 0;
    std::size_t different = 0;                 ///< with the result declared precise
    std::size_t different_if_not_precise = 0;  ///< without
    std::uint64_t max_ulp = 0;
};

struct BuiltinReport {
    std::vector<BuiltinRow> builtins;
    std::vector<OperationRow> operations;
};

/// Measures and fills driver_errors(). Needs a current context.
BuiltinReport measure_builtins(std::uint64_t seed);

}  // namespace parity
