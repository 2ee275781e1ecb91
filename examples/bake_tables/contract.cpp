#include "contract.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <thread>

#include "look_up.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/machine.hpp"

namespace bake_tables {
namespace {

constexpr int read_places = 4000;
constexpr int orders = 4;
constexpr std::size_t most_texels = 1 << 22;  // larger tables are not tried

std::string text(const char* format, double number) {
    char out[64];
    std::snprintf(out, sizeof out, format, number);
    return out;
}

std::string size_text(const support::TableSize& size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height) +
           (size.depth == 1 ? "" : " x " + std::to_string(size.depth));
}

std::string byte_text(std::size_t bytes) {
    return bytes < 1024 * 1024 ? text("%.3g KiB", double(bytes) / 1024.0)
                               : text("%.3g MiB", double(bytes) / (1024.0 * 1024.0));
}

std::string time_text(double seconds) {
    return seconds < 1 ? text("%.3g ms", 1000 * seconds) : text("%.3g s", seconds);
}

/// Seconds of the fastest of as many calls as fit half a second, at least one.
double fastest(const std::function<void()>& call) {
    double best = HUGE_VAL;
    double spent = 0;
    do {
        const auto begun = std::chrono::steady_clock::now();
        call();
        const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        best = std::min(best, passed);
        spent += passed;
    } while (spent < 0.5);
    return best;
}

/// Median, 95th percentile and largest.
struct Errors {
    double median;
    double p95;
    double largest;
};

Errors summed_up(std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    const std::size_t last = errors.size() - 1;
    return {errors[last / 2], errors[last * 95 / 100], errors[last]};
}

std::string error_text(const Errors& errors) {
    return text("%.2g", errors.median) + " / " + text("%.2g", errors.p95) + " / " +
           text("%.2g", errors.largest);
}

/// Relative to the exact number or to a millionth of the largest.
Errors errors_of(const Compared& compared) {
    double largest = 0;
    for (const double number : compared.exact) {
        largest = std::max(largest, std::fabs(number));
    }
    std::vector<double> errors;
    for (std::size_t n = 0; n < compared.exact.size(); ++n) {
        errors.push_back(std::fabs(compared.read[n] - compared.exact[n]) /
                         std::max(std::fabs(compared.exact[n]), 1e-6 * largest));
    }
    return summed_up(std::move(errors));
}

/// A column for each storage: what the table is off by.
std::string error_columns(const Kind& kind, const Request& request, const Numbers& numbers,
                          const PlaceChoice& choice) {
    std::string columns;
    for (const Storage storage : {Storage::single_float, Storage::half_float, Storage::root_half}) {
        if (storage == Storage::root_half && kind.may_be_negative) {
            columns += " - |";
            continue;
        }
        const StoredNumbers table(request.size, kind.channels.size(), numbers, storage);
        const LookUp look_up = [&](const airlight::vec3<double>& uvw) { return table.at(uvw); };
        columns += " " + error_text(errors_of(kind.compare(request, look_up, choice))) + " |";
    }
    return columns;
}

/// A quarter, half, as it is, and double along every axis that has more than one texel.
std::vector<support::TableSize> sizes_around(const Kind& kind) {
    std::vector<support::TableSize> sizes;
    for (const int quarters : {1, 2, 4, 8}) {
        const auto side = [&](int full) { return full == 1 ? 1 : full * quarters / 4; };
        const support::TableSize size{side(kind.size.width), side(kind.size.height),
                                      kind.layered ? kind.size.depth : side(kind.size.depth)};
        if (support::texel_count(size) <= most_texels && kind.takes_size(size)) {
            sizes.push_back(size);
        }
    }
    return sizes;
}

const char* const storages = "as float | as half | as half of the square root |\n|---|---|---|---|\n";

std::string error_table(const Kind& kind, const support::Preset& preset) {
    std::string page = std::string("| texels | ") + storages;
    for (const support::TableSize& size : sizes_around(kind)) {
        const Request request{preset, size, 1};  // orders are not compared beyond the first
        const Numbers numbers = kind.on_cpu(request, support::Rows(kind.name + " " + size_text(size)));
        page += "| " + size_text(size) + " |" + error_columns(kind, request, numbers, {read_places}) + "\n";
    }
    return page;
}

/// Sun by sun: where halves lose the light.
std::string twilight_table(const Kind& kind, const support::Preset& preset) {
    const Request request{preset, kind.size, 1};
    const Numbers numbers = kind.on_cpu(request, support::Rows(kind.name + " in twilight"));
    std::string page = std::string("| sun | ") + storages;
    for (const double elevation : {30.0, 0.0, -3.0, -6.0, -9.0, -12.0}) {
        page += "| " + text("%g", elevation) + " degrees |" +
                error_columns(kind, request, numbers, {read_places / 10, elevation}) + "\n";
    }
    return page;
}

std::string section(const Kind& kind, const support::Preset& preset, double cpu, double gpu) {
    std::string channels;
    for (const std::string& channel : kind.channels) {
        channels += (channels.empty() ? "" : ", ") + channel;
    }
    const std::size_t numbers = support::texel_count(kind.size) * kind.channels.size();
    std::string what = kind.what;
    what[0] = char(std::toupper(what[0]));
    std::string page = "## " + kind.name + "\n\n" + what + ".\n\n";
    page += "| | |\n|---|---|\n";
    page += "| payload | " + kind.payload + " |\n";
    page += "| channels | " + channels + " |\n";
    page += "| units | " + kind.units + " |\n";
    page += "| mapping | `" + kind.mapping + "` |\n";
    page += "| size | " + size_text(kind.size) + " texels |\n";
    page += "| bytes | " + byte_text(2 * numbers) + " in half, " + byte_text(4 * numbers) + " in float |\n";
    page += "| baked in | " + time_text(cpu) + " on the CPU, " + time_text(gpu) + " by OpenGL" +
            (kind.has_orders ? ", " + std::to_string(orders) + " orders" : "") + " |\n\n";
    if (kind.compare) {
        page += error_table(kind, preset) + "\n";
        if (kind.has_sun) {
            page += twilight_table(kind, preset) + "\n";
        }
    }
    if (!kind.remark.empty()) {
        page += kind.remark + "\n\n";
    }
    return page;
}

/// The sections of a page by their tables' names, or nothing. Each ends in one empty line.
std::map<std::string, std::string> sections_of(const std::filesystem::path& path) {
    std::map<std::string, std::string> sections;
    if (!std::filesystem::exists(path)) {
        return sections;
    }
    std::istringstream lines(support::read_file(path) + "\n");
    std::string name;
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, 3, "## ") == 0) {
            name = line.substr(3);
        }
        if (!name.empty()) {
            sections[name] += line + "\n";
        }
    }
    return sections;
}

}  // namespace

void write_contract(const std::filesystem::path& path, const std::string& renderer,
                    const std::vector<std::string>& names) {
    const std::map<std::string, std::string> kept = sections_of(path);
    const support::Preset preset = support::preset("earth");
    std::string page =
        "# Tables: what each holds, how far it is off, what it costs\n\n"
        "Written by `bake_tables --contract docs/tables.md`; do not edit. Measured for Earth on " +
        support::processor_name() + " (" + std::to_string(std::thread::hardware_concurrency()) +
        " threads), OpenGL by " + renderer +
        ".\nTimes are the fastest of a few; a driver that keeps compiled shaders, as this one does, does not "
        "compile "
        "them again.\n\n"
        "Errors are median / 95 % / largest over " +
        std::to_string(read_places) +
        " look-ups as a scene would make them, every channel by itself, relative\n"
        "to the exact function in double, or to a millionth of its largest value where it is less. Every "
        "texture "
        "is\nfiltered linearly and clamped to the edge. \"Half of the square root\" is `stored_light` of "
        "`table_storage.hpp`.\n\n";
    for (const Kind& kind : kinds()) {
        const auto before = kept.find(kind.name);
        const bool chosen = names.empty() || std::find(names.begin(), names.end(), kind.name) != names.end();
        if (!chosen && before != kept.end()) {
            page += before->second;
            continue;
        }
        const Request request{preset, kind.size, orders};
        const double cpu = fastest([&] { kind.on_cpu(request, support::Rows(kind.name + " on the CPU")); });
        const double gpu = fastest([&] {
            GpuBaker baker(preset, support::Rows(kind.name + " by OpenGL"));
            kind.on_gpu(request, baker);
        });
        page += section(kind, preset, cpu, gpu);
    }
    page.pop_back();
    support::write_file(path, page);
}

void check_contract(const std::filesystem::path& path) {
    std::vector<std::string> wanted;
    for (const Kind& kind : kinds()) {
        wanted.push_back(kind.name);
    }
    std::vector<std::string> found;
    std::istringstream lines(support::read_file(path));
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, 3, "## ") == 0) {
            found.push_back(line.substr(3));
        }
    }
    if (found != wanted) {
        throw support::Error(
            "'" + path.string() +
            "' does not have the tables there are; write it anew with bake_tables --contract");
    }
}

}  // namespace bake_tables
