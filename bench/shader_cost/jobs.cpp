#include "jobs.hpp"

#include <algorithm>
#include <cctype>

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

void add_function(const Library& library, const support::Function& function, std::vector<Job>& out) {
    const std::vector<Setting> all = settings(library, function);
    const auto add = [&](const Setting& setting, const std::string& flags, std::vector<Define> defines) {
        defines.insert(defines.end(), setting.defines.begin(), setting.defines.end());
        out.push_back({function.name, setting.text, flags, setting.counts,
                       [&library, &function, defines](const std::vector<int>& counts) {
                           return function_shader(library, function, defines, counts);
                       }});
    };
    for (const Setting& setting : all) {
        add(setting, "default", {});
    }
    for (const std::string& name : function.flags) {
        const support::Flag& flag = library.manifest.flag(name);
        for (const std::string& value : other_values(flag)) {
            add(all.front(), flag_text(flag, value), {{flag.macro, value}});
        }
    }
}

}  // namespace

std::vector<Job> library_jobs(const Library& library) {
    std::vector<Job> out;
    for (const support::Function& function : library.manifest.functions) {
        add_function(library, function, out);
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
