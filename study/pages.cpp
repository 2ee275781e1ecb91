#include "pages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "methods.hpp"
#include "support/error.hpp"

namespace study {
namespace {

const std::string none = "–";

/// Two digits that count, never as a power of ten.
std::string two_digits(double number) {
    if (!(std::abs(number) > 0) || !std::isfinite(number)) {
        return number == 0 ? "0" : none;
    }
    // Rounded first: 0.996 is 1.0, not 1.00.
    char text[64];
    std::snprintf(text, sizeof text, "%.1e", number);
    const double rounded = std::strtod(text, nullptr);
    const int magnitude = std::atoi(std::strchr(text, 'e') + 1);
    std::snprintf(text, sizeof text, "%.*f", std::max(0, 1 - magnitude), magnitude < 2 ? rounded : number);
    return text;
}

std::string whole(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", number);
    return text;
}

std::string line(const std::vector<std::string>& cells) {
    std::string out = "|";
    for (const std::string& cell : cells) {
        out += " " + cell + " |";
    }
    return out + "\n";
}

std::string table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows) {
    std::string out = line(heads) + "|";
    for (std::size_t i = 0; i < heads.size(); ++i) {
        out += "---|";
    }
    out += "\n";
    for (const std::vector<std::string>& row : rows) {
        out += line(row);
    }
    return out;
}

/// The figures of one setting, looked up by name.
class Figures {
  public:
    Figures(const Tables& tables, const Setting& setting)
        : tables_(tables),
          name_(name_of(setting.method)),
          text_(text_of(setting)),
          // The GPU's table counts what the function is given: CS562's takes samples, one more than steps.
          given_(std::to_string(setting.steps + (setting.method == Method::cs562 ? 1 : 0))) {}

    double error(const std::string& views, const std::string& column) const {
        return number(tables_.errors, {{"method", name_}, {"setting", text_}, {"views", views}}, column);
    }
    double cost(const std::string& column) const {
        return number(tables_.cost, {{"method", name_}, {"setting", text_}}, column);
    }
    /// NaN where the GPU's table has no such row.
    double gpu(const std::string& column) const {
        for (const std::string& name : {name_, "baseline::" + name_}) {
            for (const std::string& text : {text_, given_}) {
                const std::size_t row =
                    tables_.gpu.columns.empty()
                        ? 0
                        : tables_.gpu.find({{"method", name}, {"setting", text}, {"flags", "default"}});
                if (row < tables_.gpu.rows.size()) {
                    return tables_.gpu.number(row, column);
                }
            }
        }
        return std::nan("");
    }

  private:
    double number(const Csv& csv, const std::map<std::string, std::string>& cells,
                  const std::string& column) const {
        const std::size_t row = csv.find(cells);
        if (row == csv.rows.size()) {
            throw support::Error("the tables of the study have no row for " + name_ + " " + text_ +
                                 "; run study/run");
        }
        return csv.number(row, column);
    }

    const Tables& tables_;
    std::string name_;
    std::string text_;
    std::string given_;
};

double gpu_ratio(const Tables& tables, const Setting& setting) {
    const std::string cycles = "inverse_throughput_cycles";
    return Figures(tables, setting).gpu(cycles) / Figures(tables, yardstick()).gpu(cycles);
}

std::string gpu_text(double number) {
    return std::isnan(number) ? none : two_digits(number);
}

std::vector<Setting> node_settings() {
    std::vector<Setting> out;
    std::copy_if(settings().begin(), settings().end(), std::back_inserter(out),
                 [](const Setting& s) { return s.method == Method::nodes; });
    return out;
}

std::string measured(const Tables& tables) {
    std::string out;
    for (const Csv* csv : {&tables.errors, &tables.cost, &tables.classes}) {
        for (const std::string& comment : csv->comments) {
            out += "- " + comment + "\n";
        }
    }
    for (const std::string& comment : tables.gpu.comments) {
        out += "- GPU: " + comment + "\n";
    }
    return out;
}

std::string methods(const Tables& tables) {
    std::vector<std::vector<std::string>> rows;
    for (const Setting& setting : settings()) {
        const Figures f(tables, setting);
        const bool ours = setting.method == Method::nodes;
        const std::string mark = ours ? "**" : "";
        rows.push_back({mark + title_of(setting.method) + mark, text_of(setting), whole(f.cost("exp")),
                        two_digits(f.cost("ratio")), gpu_text(gpu_ratio(tables, setting)),
                        percent(f.error("suite", "max")), percent(f.error("suite", "p95")),
                        percent(f.error("suite", "median")), percent(f.error("suite", "rms")),
                        percent(f.error("random", "p95")), percent(f.error("random", "max"))});
    }
    return table({"method", "setting", "exp per ray", "CPU", "GPU", "max %", "p95 %", "median %", "rms %",
                  "random p95 %", "random max %"},
                 rows);
}

/// A row for each number of nodes, a column for each world.
template <typename Cell>
std::string by_world(const Cell& cell) {
    std::vector<std::string> heads = {"nodes"};
    for (const World& world : worlds()) {
        heads.push_back(world.title);
    }
    std::vector<std::vector<std::string>> rows;
    for (const Setting& setting : node_settings()) {
        std::vector<std::string> row = {text_of(setting)};
        for (const World& world : worlds()) {
            row.push_back(cell(setting, world));
        }
        rows.push_back(row);
    }
    return table(heads, rows);
}

std::string world_errors(const Tables& tables) {
    return by_world([&](const Setting& setting, const World& world) {
        const Figures f(tables, setting);
        return percent(f.error(world.name, "max")) + " / " + percent(f.error(world.name, "p95"));
    });
}

std::string world_costs(const Tables& tables) {
    return by_world([&](const Setting& setting, const World& world) {
        return two_digits(Figures(tables, setting).cost("ratio_" + world.name));
    });
}

/// The settings that the others' documents and programs name.
std::vector<Setting> named_settings() {
    return {{Method::leenman, 12, 4},  {Method::leenman, 16, 6},  {Method::cs562, 20, 0},
            {Method::cs562, 30, 0},    {Method::cs562, 800, 0},   {Method::double_loop, 64, 0},
            {Method::hillaire, 30, 0}, {Method::schueler, 64, 0}, {Method::hdrp, 64, 0},
            {Method::marched, 64, 0},  {Method::marched, 512, 0}};
}

/// For each named setting the fewest nodes that are as good, and how much cheaper they are.
std::string as_good(const Tables& tables) {
    std::vector<std::vector<std::string>> rows;
    for (const Setting& other : named_settings()) {
        const Figures theirs(tables, other);
        for (const Setting& setting : node_settings()) {
            const Figures ours(tables, setting);
            if (ours.error("suite", "p95") <= theirs.error("suite", "p95")) {
                const double gpu = gpu_ratio(tables, other) / gpu_ratio(tables, setting);
                rows.push_back({title_of(other.method), text_of(other), percent(theirs.error("suite", "p95")),
                                text_of(setting), percent(ours.error("suite", "p95")),
                                two_digits(theirs.cost("ratio") / ours.cost("ratio")), gpu_text(gpu)});
                break;
            }
        }
    }
    return table(
        {"method", "setting", "its p95 %", "nodes", "their p95 %", "cheaper on the CPU, times", "on the GPU"},
        rows);
}

std::string kinds(const Tables& tables) {
    const Csv& csv = tables.classes;
    std::vector<std::string> heads = {"eye in", "air", "sun", "rays"};
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < csv.rows.size(); ++i) {
        const std::string nodes = csv.cell(i, "nodes");
        if (std::find(heads.begin(), heads.end(), nodes) == heads.end()) {
            heads.push_back(nodes);
        }
        const std::vector<std::string> key = {csv.cell(i, "eye"), csv.cell(i, "air"), csv.cell(i, "sun"),
                                              csv.cell(i, "count")};
        auto row = std::find_if(rows.begin(), rows.end(), [&](const std::vector<std::string>& r) {
            return std::equal(key.begin(), key.end(), r.begin());
        });
        row = row == rows.end() ? rows.insert(rows.end(), key) : row;
        row->push_back(percent(csv.number(i, "p95")) + " / " + percent(csv.number(i, "max")));
    }
    return table(heads, rows);
}

std::string gpu(const Tables& tables) {
    std::vector<std::vector<std::string>> rows;
    for (const Setting& setting : settings()) {
        const Figures f(tables, setting);
        if (!std::isnan(f.gpu("instructions"))) {
            rows.push_back({title_of(setting.method), text_of(setting), whole(f.gpu("instructions")),
                            whole(f.gpu("vgprs")), whole(f.gpu("latency_cycles")),
                            whole(f.gpu("inverse_throughput_cycles")), gpu_text(gpu_ratio(tables, setting))});
        }
    }
    return table({"method", "setting", "instructions", "VGPRs", "latency, cycles",
                  "inverse throughput, cycles", "Leenman 16x6 = 1"},
                 rows);
}

std::string trade(const Tables& tables) {
    std::vector<std::vector<std::string>> rows;
    const auto add = [&](const Setting& setting, const std::string& name) {
        const Figures f(tables, setting);
        rows.push_back({name, percent(f.error("suite", "p95")), percent(f.error("suite", "max")),
                        two_digits(f.cost("ratio")), gpu_text(gpu_ratio(tables, setting))});
    };
    for (const Setting& setting : node_settings()) {
        add(setting, text_of(setting) + " nodes");
    }
    add(yardstick(), "Leenman's shader, 16x6");
    add({Method::hillaire, 30, 0}, "Hillaire's march, 30 steps, 256x64 table");
    add({Method::double_loop, 64, 0}, "double loop, 64x(64+64)");
    return table({"nodes or method", "95 % of views within, %", "worst view, %", "CPU time", "GPU cycles"},
                 rows);
}

}  // namespace

std::string percent(double share) {
    return two_digits(100 * share);
}

Tables read_tables(const std::filesystem::path& results, const std::filesystem::path& gpu_file) {
    Tables out;
    out.errors = read_csv(results / "errors.csv");
    out.cost = read_csv(results / "cost.csv");
    out.classes = read_csv(results / "classes.csv");
    if (std::filesystem::exists(gpu_file)) {
        out.gpu = read_csv(gpu_file);
    }
    return out;
}

std::map<std::string, std::string> blocks(const Tables& tables) {
    return {{"measured", measured(tables)},
            {"methods", methods(tables)},
            {"worlds", world_errors(tables)},
            {"world costs", world_costs(tables)},
            {"as good", as_good(tables)},
            {"kinds", kinds(tables)},
            {"gpu", gpu(tables)},
            {"trade", trade(tables)}};
}

std::string filled(const std::string& text, const std::map<std::string, std::string>& all) {
    const std::string opening = "<!-- study: ";
    const std::string closing = " -->\n";
    const std::string end = "<!-- study: end -->";
    std::string out;
    std::size_t position = 0;
    for (std::size_t marker = text.find(opening); marker != std::string::npos;
         marker = text.find(opening, position)) {
        const std::size_t name_at = marker + opening.size();
        const std::size_t name_end = text.find(closing, name_at);
        if (name_end == std::string::npos) {
            throw support::Error("a marker '" + opening + "...' without '-->' at the end of its line");
        }
        const std::string name = text.substr(name_at, name_end - name_at);
        const auto block = all.find(name);
        const std::size_t stop = text.find(end, name_end);
        if (block == all.end()) {
            throw support::Error("the marker '" + opening + name + "' names no block of figures");
        }
        if (stop == std::string::npos || text.find(opening, name_end) != stop) {
            throw support::Error("the marker '" + opening + name + "' has no '" + end + "' after it");
        }
        out += text.substr(position, name_end + closing.size() - position) + "\n" + block->second + "\n";
        position = stop;
        out += end;
        position += end.size();
    }
    return out + text.substr(position);
}

}  // namespace study
