#include "variants.hpp"

#include <airlight/nodes_for.hpp>
#include <algorithm>
#include <cctype>

namespace bench {
namespace {

/// Of functions that march; flags are tried at the first.
const std::vector<int> step_counts = {16, 8, 32, 64, 128, 256, 512};

const char* const nodes_flag = "nodes";

/// The values of a flag other than its default; none of a flag that counts, such as the nodes.
std::vector<std::string> other_values(const support::Flag& flag) {
    if (flag.name == nodes_flag) {
        return {};
    }
    std::vector<std::string> out = flag.type == "bool" ? std::vector<std::string>{"0", "1"} : flag.choices;
    out.erase(std::remove(out.begin(), out.end(), flag.default_value), out.end());
    return out;
}

}  // namespace

std::vector<Variant> settings(const support::Manifest& manifest, const support::Function& function) {
    const auto takes_steps = [](const support::Member& p) { return p.name == "steps"; };
    std::vector<Variant> out;
    if (std::any_of(function.parameters.begin(), function.parameters.end(), takes_steps)) {
        for (const int steps : step_counts) {
            out.push_back({std::to_string(steps), "default", {}, {steps}});
        }
    }
    if (std::find(function.flags.begin(), function.flags.end(), nodes_flag) != function.flags.end()) {
        const support::Flag& flag = manifest.flag(nodes_flag);
        out.push_back({flag.default_value, "default", {}, {}});
        for (const int count : airlight::node_counts) {
            const std::string nodes = std::to_string(count);
            if (nodes != flag.default_value) {
                out.push_back({nodes, "default", {{flag.name, flag.macro, nodes}}, {}});
            }
        }
    }
    if (out.empty()) {
        out.push_back({});
    }
    return out;
}

std::vector<Variant> flag_variants(const support::Manifest& manifest, const support::Function& function,
                                   const Variant& variant) {
    std::vector<Variant> out;
    for (const std::string& name : function.flags) {
        const support::Flag& flag = manifest.flag(name);
        for (const std::string& value : other_values(flag)) {
            Variant one = variant;
            one.flags = flag_text(flag, value);
            one.values.push_back({flag.name, flag.macro, value});
            out.push_back(one);
        }
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

}  // namespace bench
