#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "support/error.hpp"

namespace shader_cost {
namespace {

struct Column {
    const char* name;
    double& (*of)(Price& price);
};

const Column columns[] = {
    {"instructions", [](Price& p) -> double& { return p.counts.instructions; }},
    {"vgprs", [](Price& p) -> double& { return p.vgprs; }},
    {"latency_cycles", [](Price& p) -> double& { return p.latency; }},
    {"inverse_throughput_cycles", [](Price& p) -> double& { return p.inverse_throughput; }},
    {"vector_instructions", [](Price& p) -> double& { return p.counts.vector; }},
    {"transcendental_instructions", [](Price& p) -> double& { return p.counts.transcendental; }},
    {"sgprs", [](Price& p) -> double& { return p.sgprs; }},
    {"spilled_registers", [](Price& p) -> double& { return p.spilled; }},
    {"code_bytes", [](Price& p) -> double& { return p.code_bytes; }},
};

/// As it is written: whole.
long long value(const Column& column, Price price) {
    return std::llround(column.of(price));
}

std::string header() {
    std::string out = "method,setting,flags";
    for (const Column& column : columns) {
        out += std::string(",") + column.name;
    }
    return out + ",loops";
}

std::string whole(double number) {
    return std::to_string(std::llround(number));
}

const Row* find(const std::vector<Row>& rows, const std::string& wanted) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return key(r) == wanted; });
    return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::string key(const Row& row) {
    return row.method + (row.setting.empty() ? "" : ", " + row.setting) +
           (row.flags == "default" ? "" : ", " + row.flags);
}

std::string csv(const std::vector<Row>& rows, const std::string& made_by) {
    std::string out = "# " + made_by + "\n" + header() + "\n";
    for (const Row& row : rows) {
        out += row.method + "," + row.setting + "," + row.flags;
        for (const Column& column : columns) {
            out += "," + std::to_string(value(column, row.price));
        }
        out += "," + row.loops + "\n";
    }
    return out;
}

Table read_csv(const std::string& text, const std::string& name) {
    const auto refuse = [&](const std::string& what) {
        throw support::Error(name + ": " + what + "; write it anew with shader_cost --write");
    };
    Table out;
    std::istringstream lines(text);
    std::string line;
    if (!std::getline(lines, line) || line.compare(0, 2, "# ") != 0) {
        refuse("does not begin with a comment");
    }
    out.made_by = line.substr(2);
    if (!std::getline(lines, line) || line != header()) {
        refuse("has other columns than this program writes");
    }
    while (std::getline(lines, line)) {
        std::istringstream fields(line);
        Row row;
        std::getline(fields, row.method, ',');
        std::getline(fields, row.setting, ',');
        std::getline(fields, row.flags, ',');
        for (const Column& column : columns) {
            char comma = 0;
            fields >> column.of(row.price) >> comma;
        }
        if (!fields || !std::getline(fields, row.loops)) {
            refuse("is not understood at '" + line + "'");
        }
        out.rows.push_back(row);
    }
    return out;
}

void print(std::ostream& out, const std::vector<Row>& rows) {
    std::size_t width = 0;
    for (const Row& row : rows) {
        width = std::max(width, key(row).size());
    }
    const auto line = [&](const std::string& name, const std::vector<std::string>& cells) {
        out << std::left << std::setw(static_cast<int>(width)) << name << std::right;
        for (const std::string& cell : cells) {
            out << std::setw(13) << cell;
        }
        out << "\n";
    };
    line("", {"instructions", "vector", "transcend.", "VGPRs", "code bytes", "latency", "cycles", "loops"});
    for (const Row& row : rows) {
        const Price& p = row.price;
        line(key(row),
             {whole(p.counts.instructions), whole(p.counts.vector), whole(p.counts.transcendental),
              whole(p.vgprs), whole(p.code_bytes), whole(p.latency), whole(p.inverse_throughput), row.loops});
    }
}

std::vector<std::string> differences(const std::vector<Row>& recorded, const std::vector<Row>& measured,
                                     bool listing_only) {
    std::vector<std::string> out;
    for (const Row& row : measured) {
        const Row* const old = find(recorded, key(row));
        if (old == nullptr) {
            out.push_back(key(row) + ": is not recorded");
            continue;
        }
        std::string changes;
        for (const Column& column : columns) {
            const long long before = value(column, old->price);
            const long long now = value(column, row.price);
            if (!listing_only && before != now) {
                changes += (changes.empty() ? "" : ", ") + std::string(column.name) + " " +
                           std::to_string(before) + " -> " + std::to_string(now);
            }
        }
        if (!changes.empty()) {
            out.push_back(key(row) + ": " + changes);
        }
    }
    for (const Row& row : recorded) {
        if (find(measured, key(row)) == nullptr) {
            out.push_back(key(row) + ": is recorded, but no longer measured");
        }
    }
    return out;
}

}  // namespace shader_cost
