#include "advice.hpp"

#include <airlight/nodes_for.hpp>
#include <tuple>

namespace advise {
namespace {

Setting without_mie(Setting setting) {
    setting.mie = false;
    return setting;
}

Setting without_ozone(Setting setting) {
    setting.ozone = airlight::ozone_none;
    return setting;
}

Setting without_shadow(Setting setting) {
    setting.planet_shadow = false;
    return setting;
}

Setting with_nodes(Setting setting, int nodes) {
    setting.nodes = nodes;
    return setting;
}

/// Every choice of terms at every number of nodes.
std::vector<Setting> combinations(const Setting& reference) {
    std::vector<Setting> out;
    for (const int nodes : airlight::node_counts) {
        for (const bool mie : {false, true}) {
            for (const bool ozone : {false, true}) {
                for (const bool shadow : {false, true}) {
                    Setting setting = with_nodes(reference, nodes);
                    setting = mie ? setting : without_mie(setting);
                    setting = ozone ? setting : without_ozone(setting);
                    setting = shadow ? setting : without_shadow(setting);
                    if (ozone && reference.ozone == airlight::ozone_none) {
                        continue;  // the same as without
                    }
                    out.push_back(setting);
                }
            }
        }
    }
    return out;
}

void measure_terms(const Measured& measured, Advice& advice) {
    const Setting& reference = measured.reference;
    const auto add = [&](const char* name, const Change& change, bool has_flag) {
        advice.terms.push_back({name, change, has_flag, false});
    };
    add(mie_name, change_by(measured, without_mie(reference)), true);
    if (reference.ozone != airlight::ozone_none) {
        add(ozone_name, change_by(measured, without_ozone(reference)), true);
    }
    add(shadow_name, change_by(measured, without_shadow(reference)), true);
    add(curvature_name, change_in(measured, flat(measured.air)), false);
    add(top_name, change_in(measured, endless(measured.air)), false);
    for (const int nodes : airlight::node_counts) {
        advice.nodes.push_back({nodes, change_by(measured, with_nodes(reference, nodes))});
    }
}

/// Whether the advice leaves the term of this name out.
bool left_out(const std::string& name, const Setting& setting) {
    return (name == mie_name && !setting.mie) ||
           (name == ozone_name && setting.ozone == airlight::ozone_none) ||
           (name == shadow_name && !setting.planet_shadow);
}

/// Everything that stays within the tolerance by itself, together.
Setting each_alone(const Advice& advice, const Setting& reference) {
    Setting out = reference;
    for (const Contribution& term : advice.terms) {
        if (!term.has_flag || judged(term.change, advice.by) > advice.tolerance) {
            continue;
        }
        out = term.name == mie_name     ? without_mie(out)
              : term.name == ozone_name ? without_ozone(out)
                                        : without_shadow(out);
    }
    for (const NodeCost& cost : advice.nodes) {
        if (judged(cost.change, advice.by) <= advice.tolerance) {
            return with_nodes(out, cost.nodes);
        }
    }
    return out;
}

}  // namespace

double judged(const Change& change, By by) {
    return by == By::worst ? change.worst : change.p95;
}

int work_of(const Setting& setting) {
    return setting.nodes * (1 + (setting.mie ? 1 : 0) + (setting.ozone != airlight::ozone_none ? 1 : 0));
}

Advice advised(const Measured& measured, double tolerance, By by, int doubt_steps,
               const std::function<void(double)>& progress) {
    const Setting& reference = measured.reference;
    Advice out{};
    out.tolerance = tolerance;
    out.by = by;
    progress(0.0);
    out.doubt = doubt(measured, doubt_steps);
    progress(0.5);
    measure_terms(measured, out);
    progress(0.6);

    const auto rank = [](const Setting& setting, const Change& change) {
        return std::make_tuple(work_of(setting), setting.planet_shadow, change.worst);
    };
    out.setting = reference;
    out.change = Change{};  // the reference itself
    const std::vector<Setting> all = combinations(reference);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Change change = change_by(measured, all[i]);
        if (judged(change, by) <= tolerance && rank(all[i], change) < rank(out.setting, out.change)) {
            out.setting = all[i];
            out.change = change;
        }
        progress(0.6 + 0.4 * static_cast<double>(i + 1) / static_cast<double>(all.size()));
    }
    for (Contribution& term : out.terms) {
        term.left_out = left_out(term.name, out.setting);
    }
    out.each = each_alone(out, reference);
    out.each_change = change_by(measured, out.each);
    return out;
}

}  // namespace advise
