#include "jobs.hpp"

#include <algorithm>
#include <cctype>

#include "support/error.hpp"

namespace shader_cost {
namespace {

/// Of functions that march.
const std::vector<int> step_counts = {16, 32, 64};
/// Of the node method, every number that it has constants for.
const std::vector<int> node_counts = {4, 5, 6, 8, 10, 12, 16, 24};

const char* const nodes_flag = "nodes";

/// The values of a flag other than its default; none of a flag that counts, such as the nodes.
std::vector<std::string> other_values(const support::Flag& flag) {
    std::vector<std::string> out = flag.type == "bool" ? std::vector<std::string>{"0", "1"} : flag.choices;
    out.erase(std::remove(out.begin(), out.end(), flag.default_value), out.end());
    return out;
}

/// One row of the table for a function without flags of its own.
struct Setting {
    std::string text;
    std::vector<Define> defines;
    std::vector<int> counts;
};

/// The settings of a function: its steps, its nodes, or the one that every function has. The first is the one
/// at which flags are tried.
std::vector<Setting> settings(const Library& library, const support::Function& function) {
    const auto takes_steps = [](const support::Member& p) { return p.type == "int"; };
    std::vector<Setting> out;
    if (std::any_of(function.parameters.begin(), function.parameters.end(), takes_steps)) {
        for (const int steps : step_counts) {
            out.push_back({std::to_string(steps), {}, {steps}});
        }
    }
    if (std::find(function.flags.begin(), function.flags.end(), nodes_flag) != function.flags.end()) {
        const support::Flag& flag = library.manifest.flag(nodes_flag);
        const auto add = [&](const std::string& nodes) { out.push_back({nodes, {{flag.macro, nodes}}, {}}); };
        add(flag.default_value);
        for (const int nodes : node_counts) {
            if (std::to_string(nodes) != flag.default_value) {
                add(std::to_string(nodes));
            }
        }
    }
    if (out.empty()) {
        out.push_back({});
    }
    return out;
}

/// A function at all its settings, and with each flag at each other value.
struct Subject {
    const support::Function* function = nullptr;
    std::string method;
    std::vector<Setting> settings;
    int degree = 1;  ///< of the number of passes in the function's count
};

void add(const Library& library, const Subject& subject, std::vector<Job>& out) {
    const support::Function& function = *subject.function;
    const auto add_job = [&](const Setting& setting, const std::string& flags, std::vector<Define> defines) {
        defines.insert(defines.end(), setting.defines.begin(), setting.defines.end());
        out.push_back({subject.method, setting.text, flags, setting.counts,
                       [&library, &function, defines](const std::vector<int>& counts) {
                           return function_shader(library, function, defines, counts);
                       },
                       subject.degree});
    };
    for (const Setting& setting : subject.settings) {
        add_job(setting, "default", {});
    }
    for (const std::string& name : function.flags) {
        const support::Flag& flag = library.manifest.flag(name);
        for (const std::string& value : other_values(flag)) {
            add_job(subject.settings.front(), flag_text(flag, value), {{flag.macro, value}});
        }
    }
}

struct Baseline {
    const char* name;
    std::vector<std::vector<int>> counts;
    int degree = 1;
};

/// With the settings that their authors and users give; see study/baselines.
const std::vector<Baseline> baselines_and_settings = {
    {"leenman", {{16, 6}, {12, 4}, {64, 16}, {256, 64}}},
    {"cs562", {{21}, {31}, {801}}},
    {"hillaire", {{30}}},
    {"schueler", {{64}}},
    {"hdrp", {{64}, {256}}},
    {"double_loop", {{64}}, 2},
};

}  // namespace

std::vector<Job> library_jobs(const Library& library) {
    std::vector<Job> out;
    for (const support::Function& function : library.manifest.functions) {
        add(library, {&function, function.name, settings(library, function)}, out);
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
        Subject subject{function, baseline.name, {}, baseline.degree};
        for (const std::vector<int>& counts : baseline.counts) {
            std::string text;
            for (const int count : counts) {
                text += (text.empty() ? "" : "x") + std::to_string(count);
            }
            subject.settings.push_back({text, {}, counts});
        }
        add(baselines, subject, out);
    }
    return out;
}

std::string off_value(const support::Flag& flag) {
    if (flag.type == "bool") {
        return flag.default_value == "0" ? "" : "0";
    }
    const std::string none = "_NONE";
    for (const std::string& choice : flag.choices) {
        if (choice.size() > none.size() &&
            choice.compare(choice.size() - none.size(), none.size(), none) == 0) {
            return choice;
        }
    }
    return "";
}

std::string flag_text(const support::Flag& flag, const std::string& value) {
    // AIRLIGHT_OZONE_NONE of ozone is none; AIRLIGHT_PHASE_FOG of mie_phase is fog.
    std::string text = value;
    if (!flag.choices.empty()) {
        std::size_t shared = flag.choices.front().size();
        for (const std::string& choice : flag.choices) {
            std::size_t same = 0;
            while (same < shared && same < choice.size() && choice[same] == flag.choices.front()[same]) {
                ++same;
            }
            shared = same;
        }
        text = value.substr(shared);
    }
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return flag.name + "=" + text;
}

}  // namespace shader_cost
