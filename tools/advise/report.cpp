#include "report.hpp"

#include <airlight/constants.hpp>
#include <airlight/nodes_for.hpp>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <sstream>

#include "emit.hpp"
#include "support/error.hpp"
#include "warnings.hpp"

namespace advise {
namespace {

std::string number(double value) {
    std::ostringstream out;
    out.precision(10);
    out << value;
    return out.str();
}

std::string text_of(const char* name, const Range& range) {
    return std::string(" --") + name + " " + number(range.low) + " " + number(range.high);
}

const char* text_of(By by) {
    return by == By::worst ? "in the worst view" : "in 95 % of the views";
}

std::string row(const std::string& name, const Change& change, const std::string& remark) {
    std::ostringstream out;
    out << "  " << std::left << std::setw(24) << name << std::right;
    for (const double share : {change.median, change.p95, change.worst}) {
        out << std::setw(11) << percent(share);
    }
    out << (remark.empty() ? "" : "  ") << remark << "\n";
    return out.str();
}

std::string heading(const std::string& what) {
    std::ostringstream out;
    out << "\n"
        << std::left << std::setw(26) << what << std::right << std::setw(11) << "median" << std::setw(11)
        << "p95" << std::setw(11) << "worst"
        << "\n";
    return out.str();
}

std::string described(const Setting& setting, const Setting& reference) {
    std::string out;
    const auto add = [&](bool off, const char* name) {
        if (off) {
            out += (out.empty() ? "without " : ", ") + std::string(name);
        }
    };
    add(!setting.mie, "aerosol");
    add(setting.ozone == airlight::ozone_none && reference.ozone != airlight::ozone_none, "ozone");
    add(!setting.planet_shadow, "planet's shadow");
    return (out.empty() ? "every term on" : out) + "; " + std::to_string(setting.nodes) + " nodes";
}

std::string remark_of(const Contribution& term, const Advice& advice) {
    const bool small = judged(term.change, advice.by) <= advice.tolerance;
    if (term.name == top_name) {
        return small ? "high enough" : "raise top_altitude";
    }
    if (!term.has_flag) {
        return small ? "always in, worth little here" : "always in";
    }
    if (term.left_out) {
        return "leave it out";
    }
    return small ? "keep: too much with what else is saved" : "keep";
}

Setting reference_of(const Question& question) {
    Setting out;
    out.ozone = question.air.ozone;
    out.mie_phase = question.mie_phase;
    out.nodes = *std::rbegin(airlight::node_counts);  // the most
    return out;
}

bool same(const Setting& a, const Setting& b) {
    return a.mie == b.mie && a.ozone == b.ozone && a.planet_shadow == b.planet_shadow && a.nodes == b.nodes;
}

std::string combined_lines(const Advice& advice, const Setting& reference) {
    std::ostringstream out;
    if (!same(advice.each, advice.setting)) {
        const bool over = judged(advice.each_change, advice.by) > advice.tolerance;
        out << (over ? "\nWhat each stays within the tolerance is too much together: "
                     : "\nWhat each stays within the tolerance is good together, but not the least work: ")
            << described(advice.each, reference) << "\nwould change " << percent(advice.each_change.median)
            << " / " << percent(advice.each_change.p95) << " / " << percent(advice.each_change.worst)
            << " %.\n";
    }
    out << "\nrecommended: " << described(advice.setting, reference) << "\n"
        << "together they change " << percent(advice.change.median) << " % (median), "
        << percent(advice.change.p95) << " % (p95), " << percent(advice.change.worst) << " % (worst view)\n";
    return out.str();
}

}  // namespace

std::string percent(double share) {
    const double value = 100.0 * share;
    if (!(value > 0)) {
        return "0";
    }
    if (value < 1e-4) {
        return "< 0.0001";
    }
    if (value >= 1000) {
        return "> 1000";
    }
    // Rounded to two digits first: 9.96 is 10, not 10.0.
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    const double rounded = std::round(value / unit) * unit;
    const int digits = std::max(0, 1 - static_cast<int>(std::floor(std::log10(rounded * (1 + 1e-9)))));
    std::ostringstream out;
    out << std::fixed << std::setprecision(digits) << rounded;
    return out.str();
}

Answer answered(const Question& question, const std::function<void(double)>& progress) {
    const Atmosphere& air = question.air.atmosphere;
    std::vector<View> views = sampled(air, question.ranges, question.views, question.seed);
    if (views.empty()) {
        throw support::Error("no view over these ranges has air in it; give larger distances");
    }
    const Measured all = measured(air, reference_of(question), std::move(views));
    Answer out;
    out.views = all.views.size();
    out.advice = advised(all, question.tolerance, question.by, doubt_steps, progress);
    for (const auto& texts :
         {warnings_of(air, all.reference), warnings_of(air, question.ranges), warnings_of(all)}) {
        out.warnings.insert(out.warnings.end(), texts.begin(), texts.end());
    }
    if (judged(out.advice.doubt, question.by) > question.tolerance) {
        out.warnings.push_back("the reference is not sure to " + percent(question.tolerance) +
                               " %: it and its march differ by " +
                               percent(judged(out.advice.doubt, question.by)) +
                               " %; a larger tolerance says more");
    }
    return out;
}

std::string summary(const Question& question, const Answer& answer) {
    std::ostringstream out;
    out << question.air_name << text_of("height", question.ranges.height)
        << text_of("sun", question.ranges.sun) << text_of("distance", question.ranges.distance)
        << " --tolerance " << number(100.0 * question.tolerance) << "\n"
        << "changes " << percent(answer.advice.change.p95) << " % (p95), "
        << percent(answer.advice.change.worst) << " % (worst) of " << answer.views << " views";
    return out.str();
}

std::string report(const Question& question, const Answer& answer) {
    const Advice& advice = answer.advice;
    const Setting reference = reference_of(question);
    std::ostringstream out;
    out << question.air_name << ": cameras at " << number(question.ranges.height.low) << " to "
        << number(question.ranges.height.high) << " m, sun at " << number(question.ranges.sun.low) << " to "
        << number(question.ranges.sun.high) << " degrees, seeing " << number(question.ranges.distance.low)
        << " to " << number(question.ranges.distance.high) << " m\n"
        << answer.views << " views; tolerance " << number(100.0 * question.tolerance) << " % "
        << text_of(question.by) << "\n";

    out << heading("change without it, %");
    for (const Contribution& term : advice.terms) {
        out << row(term.name, term.change, remark_of(term, advice));
    }
    out << "  multiple scattering was not measured: airlight has none yet\n";

    out << heading("change with so many nodes");
    for (const NodeCost& cost : advice.nodes) {
        const bool is_reference = cost.nodes == reference.nodes;
        out << row(std::to_string(cost.nodes), is_reference ? advice.doubt : cost.change,
                   is_reference
                       ? "the reference, against a march of " + std::to_string(doubt_steps) + " steps"
                       : "");
    }
    out << combined_lines(advice, reference);
    for (const std::string& text : answer.warnings) {
        out << "warning: " << text << "\n";
    }
    return out.str();
}

}  // namespace advise
