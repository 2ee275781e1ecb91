// Fills tables of light and writes them as OpenEXR files.

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contract.hpp"
#include "kinds.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"

namespace {

using namespace bake_tables;

constexpr int largest_side = 4096;
constexpr long most_texels = 64L * 1024 * 1024;

struct Options {
    std::vector<std::string> tables;
    std::string atmosphere = "earth";
    std::string size;
    int orders = 4;
    double eye_altitude = 200;
    double sun_elevation = 20;
    std::string format = "half";
    std::string on = "cpu";
    std::string output = ".";
    std::string contract;
    std::string check;
};

/// "64x32" or "32x64x16"; a table of two dimensions takes no third.
support::TableSize parsed_size(const std::string& text, const Kind& kind) {
    support::TableSize size{0, 0, 1};
    char rest = 0;
    const bool flat = kind.size.depth == 1;
    const int read =
        text.size() > 20 ? 0
        : flat           ? std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest)
               : std::sscanf(text.c_str(), "%dx%dx%d%c", &size.width, &size.height, &size.depth, &rest);
    if (read != (flat ? 2 : 3)) {
        throw support::Error("--size '" + text + "' is not understood for " + kind.name + "; write it like " +
                             (flat ? "64x32" : "32x64x16"));
    }
    for (const int side : {size.width, size.height, size.depth}) {
        if (side < 1 || side > largest_side) {
            throw support::Error("--size " + text + " is out of range; give 1 to " +
                                 std::to_string(largest_side) + " texels each way");
        }
    }
    if (long(size.width) * size.height * size.depth > most_texels) {
        throw support::Error("--size " + text + " is too large; give at most 64 million texels in all");
    }
    if (!kind.takes_size(size)) {
        throw support::Error("--size " + text + " does not do for " + kind.name + "; " + kind.size_rule);
    }
    return size;
}

std::string byte_text(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, bytes < 1024 * 1024 ? "%.4g KiB" : "%.4g MiB",
                  double(bytes) / (bytes < 1024 * 1024 ? 1024.0 : 1024.0 * 1024.0));
    return text;
}

void bake(const Kind& kind, const Options& options, bool on_gpu) {
    const Request request{support::preset(options.atmosphere),
                          options.size.empty() ? kind.size : parsed_size(options.size, kind), options.orders,
                          options.eye_altitude, options.sun_elevation};
    support::StoredTable table{describe(kind, request), {}};
    const auto begun = std::chrono::steady_clock::now();
    {
        const support::Rows rows(kind.name);
        if (on_gpu) {
            GpuBaker gpu(request.preset, rows);
            table.texels = kind.on_gpu(request, gpu);
        } else {
            table.texels = kind.on_cpu(request, rows);
        }
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (options.format == "root") {
        table = support::in_roots(table);
    }
    const bool half = options.format != "float";
    const std::filesystem::path path = std::filesystem::path(options.output) / (kind.name + ".exr");
    support::write_table(path, table,
                         half ? support::TableFormat::half_float : support::TableFormat::single_float);
    std::printf("%s: %d x %d x %d texels of %zu numbers, %s in %s, %.3g s on the %s\n", path.c_str(),
                request.size.width, request.size.height, request.size.depth, kind.channels.size(),
                byte_text(table.texels.size() * (half ? 2 : 4)).c_str(), options.format.c_str(), seconds,
                on_gpu ? "GPU" : "CPU");
    std::fflush(stdout);
}

std::string list_of_tables() {
    std::string text = "tables:";
    for (const Kind& kind : kinds()) {
        char line[200];
        std::snprintf(line, sizeof line, "\n  %-20s%s (%d x %d x %d)", kind.name.c_str(), kind.what.c_str(),
                      kind.size.width, kind.size.height, kind.size.depth);
        text += line;
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "fills tables of light and writes each as <output>/<table>.exr, with what it holds in the header",
        "bake_tables");
    using support::add_value;
    add_value(app, "--table", "<name>", options.tables,
              "one of those below; may be given again (default: all)")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_value(app, "--atmosphere", "<name>", options.atmosphere,
              "earth, cs562, elek, leenman or mars; a habitat has the air and albedo of its ground (default "
              "earth)");
    add_value(app, "--size", "<WxH or WxHxD>", options.size,
              "texels; of one table only (default: the table's own)");
    add_value(app, "--orders", "<count>", options.orders,
              "of scattering, for tables made order by order (default 4)")
        ->check(CLI::Range(1, 100));
    add_value(app, "--eye-altitude", "<metres>", options.eye_altitude, "of tables of one frame (default 200)")
        ->check(CLI::Range(0.0, 1e9));
    add_value(app, "--sun-elevation", "<degrees>", options.sun_elevation, "likewise (default 20)")
        ->check(CLI::Range(-90.0, 90.0));
    add_value(app, "--format", "<half|float|root>", options.format,
              "of the numbers in the file; root is the square root in half, for twilight (default half)")
        ->check(CLI::IsMember({"half", "float", "root"}));
    add_value(app, "--on", "<cpu|gpu>", options.on, "what computes, in float (default cpu)")
        ->check(CLI::IsMember({"cpu", "gpu"}));
    add_value(app, "--output", "<folder>", options.output, "made if it is missing (default the current one)");
    add_value(
        app, "--contract", "<file>", options.contract,
        "write the page about tables instead (docs/tables.md), measured for Earth: all or those of --table");
    add_value(app, "--check-contract", "<file>", options.check,
              "see that this page has every table, and stop");
    app.footer(list_of_tables());
    return support::guarded_main(app, argc, argv, [&] {
        if (!options.check.empty()) {
            check_contract(options.check);
            return 0;
        }
        if (!options.contract.empty()) {
            const support::GlContext gl(4, 3);
            write_contract(options.contract, gl.renderer(), options.tables);
            return 0;
        }
        std::vector<const Kind*> chosen;
        for (const std::string& name : options.tables) {
            chosen.push_back(&kind_named(name));
        }
        if (chosen.empty()) {
            for (const Kind& kind : kinds()) {
                chosen.push_back(&kind);
            }
        }
        if (!options.size.empty() && chosen.size() != 1) {
            throw support::Error("--size is for one table; give --table too");
        }
        support::preset(options.atmosphere);  // refused before the work, as is all else
        if (!options.size.empty()) {
            parsed_size(options.size, *chosen.front());
        }
        std::optional<support::GlContext> context;
        if (options.on == "gpu") {
            context.emplace(4, 3);
        }
        support::make_writable_directory(options.output);
        for (const Kind* kind : chosen) {
            if (options.format == "root" && kind->may_be_negative) {
                throw support::Error(kind->name +
                                     " has numbers below 0, which have no root; give another --format");
            }
        }
        for (const Kind* kind : chosen) {
            bake(*kind, options, context.has_value());
        }
        return 0;
    });
}
