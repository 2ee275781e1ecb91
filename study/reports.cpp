#include "reports.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/progress.hpp"

namespace study {
namespace {

using airlight_test::ErrorMetrics;

std::vector<std::string> head(const Setting& setting) {
    return {name_of(setting.method), text_of(setting)};
}

void append(std::vector<std::string>& row, const ErrorMetrics& m, std::string (*text)(double)) {
    for (const double number : {m.largest, m.p95, m.median, m.root_mean_square}) {
        row.push_back(text(number));
    }
}

/// Ten digits: what quick.csv is held to.
std::string precise(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", number);
    return text;
}

bool any(const View&) {
    return true;
}

/// The view with the largest error of those chosen.
template <typename Chosen>
std::string worst(const std::vector<double>& errors, const Judged& judged, const Chosen& chosen) {
    const View* found = nullptr;
    double largest = -1;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (chosen(judged.views[i]) && !(errors[i] <= largest)) {
            found = &judged.views[i];
            largest = errors[i];
        }
    }
    return found == nullptr ? "" : worlds()[found->world].name + ": " + found->name;
}

double sun_mu(const View& view) {
    return glm::dot(view.ray.eye.up, view.ray.to_sun);
}

/// How much there is in a world's air: what the errors of few nodes hang on.
std::string air_of(const View& view) {
    const World& world = worlds()[view.world];
    if (world.name == "thick") {
        return "thick";
    }
    return world.ozone == airlight::ozone_none ? "no ozone" : "ozone";
}

/// A kind of view, as nodes_for tells them apart.
struct Class {
    std::string sun;
    double low;
    double high;
    std::string air;
    bool space;

    bool holds(const View& view) const {
        const bool in_space = view.ray.eye.altitude > worlds()[view.world].air.top_altitude;
        const double mu = sun_mu(view);
        return in_space == space && air_of(view) == air && mu >= low && mu < high;
    }
};

std::vector<Class> classes() {
    std::vector<Class> out;
    for (const char* air : {"no ozone", "ozone", "thick"}) {
        out.push_back({"sun_mu >= 0.1", 0.1, 2.0, air, false});
        out.push_back({"0 <= sun_mu < 0.1", 0.0, 0.1, air, false});
        out.push_back({"-0.1 <= sun_mu < 0", -0.1, 0.0, air, false});
        out.push_back({"sun_mu < -0.1", -2.0, -0.1, air, false});
        out.push_back({"any", -2.0, 2.0, air, true});
    }
    return out;
}

/// What the plot of errors by view shows.
std::vector<Setting> shown_settings() {
    std::vector<Setting> out = {
        yardstick(), {Method::hillaire, 30, 0}, {Method::hdrp, 64, 0}, {Method::double_loop, 64, 0}};
    for (const int nodes : {4, 6, 8, 10, 16, 24}) {
        if (std::count(settings().begin(), settings().end(), Setting{Method::nodes, nodes, 0}) > 0) {
            out.push_back({Method::nodes, nodes, 0});
        }
    }
    return out;
}

}  // namespace

Csv error_table(const std::vector<Setting>& settings, const Judged& suite, const Judged& random) {
    Csv out;
    out.comments = {
        "Errors |Y - Y_true| / max(Y_true, 1e-4 Y(zenith at noon)), Y = Rec. 709 luminance; float_max "
        "and float_p95 in float, the others in double.",
        "Truth: adaptive quadrature, sure of itself to " + figure(std::max(suite.doubt, random.doubt)) +
            " of the radiance or better."};
    out.columns = {"method", "setting", "views",     "count",     "max",  "p95",
                   "median", "rms",     "float_max", "float_p95", "worst"};
    support::ProgressBar bar("errors");
    std::size_t done = 0;
    for (const Setting& setting : settings) {
        const std::vector<double> in_suite = errors<double>(setting, suite);
        const std::vector<double> in_random = errors<double>(setting, random);
        const std::vector<double> float_suite = errors<float>(setting, suite);
        const std::vector<double> float_random = errors<float>(setting, random);
        const auto add = [&](const std::string& views, const std::vector<double>& all,
                             const std::vector<double>& all_float, const Judged& judged, const auto& chosen) {
            const auto count = std::count_if(judged.views.begin(), judged.views.end(), chosen);
            const ErrorMetrics m = metrics(all, judged, chosen);
            const ErrorMetrics f = metrics(all_float, judged, chosen);
            std::vector<std::string> row = head(setting);
            row.insert(row.end(), {views, std::to_string(count)});
            append(row, m, figure);
            row.insert(row.end(), {figure(f.largest), figure(f.p95), worst(all, judged, chosen)});
            out.rows.push_back(row);
        };
        add("suite", in_suite, float_suite, suite, any);
        add("random", in_random, float_random, random, any);
        for (std::size_t world = 0; world < worlds().size(); ++world) {
            add(worlds()[world].name, in_suite, float_suite, suite,
                [&](const View& view) { return view.world == world; });
        }
        bar(++done, settings.size());
    }
    return out;
}

Csv view_table(const Judged& suite) {
    Csv out;
    out.comments = {
        "Each view of the suite: true luminance per unit of solar irradiance [1/sr], and errors in double."};
    out.columns = {"world", "kind", "view", "luminance"};
    std::vector<std::vector<double>> columns;
    for (const Setting& setting : shown_settings()) {
        out.columns.push_back(name_of(setting.method) + " " + text_of(setting));
        columns.push_back(errors<double>(setting, suite));
    }
    for (std::size_t i = 0; i < suite.views.size(); ++i) {
        const View& view = suite.views[i];
        std::vector<std::string> row = {worlds()[view.world].name, view.kind, view.name,
                                        figure(suite.luminance[i])};
        for (const std::vector<double>& column : columns) {
            row.push_back(figure(column[i]));
        }
        out.rows.push_back(row);
    }
    return out;
}

Csv class_table(const std::vector<Setting>& settings, const Judged& views) {
    Csv out;
    out.comments = {
        "The node method by kind of view: the eye in the air or in space; air without ozone (cs562 and "
        "mars), with it "
        "(leenman and earth) or ten times as thick; the sun's cosine to the eye's vertical. The suite and "
        "6000 "
        "random rays; errors in double."};
    out.columns = {"nodes", "eye", "air", "sun", "count", "p95", "max"};
    for (const Setting& setting : settings) {
        if (setting.method != Method::nodes) {
            continue;
        }
        const std::vector<double> all = errors<double>(setting, views);
        for (const Class& kind : classes()) {
            const auto holds = [&](const View& view) { return kind.holds(view); };
            const ErrorMetrics m = metrics(all, views, holds);
            out.rows.push_back({text_of(setting), kind.space ? "space" : "air", kind.air, kind.sun,
                                std::to_string(std::count_if(views.views.begin(), views.views.end(), holds)),
                                figure(m.p95), figure(m.largest)});
        }
    }
    return out;
}

Csv quick_table(const std::vector<Setting>& settings, const Progress& progress) {
    std::vector<View> tenth;
    const std::vector<View> all = suite();
    for (std::size_t i = 0; i < all.size(); i += 10) {
        tenth.push_back(all[i]);
    }
    const Judged judged_tenth = judged(tenth, [](std::size_t, std::size_t) {});
    Csv out;
    out.comments = {"Errors in double over every tenth view of the suite, for study --quick."};
    out.columns = {"method", "setting", "max", "p95", "median", "rms"};
    for (const Setting& setting : settings) {
        std::vector<std::string> row = head(setting);
        append(row, metrics(errors<double>(setting, judged_tenth), judged_tenth, any), precise);
        out.rows.push_back(row);
        progress(out.rows.size(), settings.size());
    }
    return out;
}

Csv cost_table(const std::vector<Setting>& settings, const std::vector<Cost>& costs) {
    Csv out;
    out.columns = {"method", "setting", "exp", "sqrt", "div", "ns", "ratio"};
    for (const World& world : worlds()) {
        out.columns.push_back("ratio_" + world.name);
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const Cost& c = costs[i];
        std::vector<std::string> row = head(settings[i]);
        for (const double number : {c.operations.exponentials, c.operations.roots, c.operations.divisions,
                                    c.nanoseconds, c.ratio}) {
            row.push_back(figure(number));
        }
        for (const double ratio : c.world_ratios) {
            row.push_back(figure(ratio));
        }
        out.rows.push_back(row);
    }
    return out;
}

std::vector<std::string> differences(const Csv& fresh, const Csv& recorded) {
    std::vector<std::string> out;
    for (std::size_t row = 0; row < fresh.rows.size(); ++row) {
        const std::string method = fresh.cell(row, "method");
        const std::string setting = fresh.cell(row, "setting");
        const std::size_t before = recorded.find({{"method", method}, {"setting", setting}});
        if (before == recorded.rows.size()) {
            out.push_back(method + " " + setting + ": nothing is recorded");
            continue;
        }
        for (const std::string column : {"max", "p95", "median", "rms"}) {
            const double now = fresh.number(row, column);
            const double then = recorded.number(before, column);
            // 1e-9: what another exp and another compiler's order of sums may move a luminance by (100
            // roundoffs of double times a condition of 1e5, the radius over the scale height of the lowest
            // layer). 1e-6 of the error: ten digits are recorded.
            if (!(std::abs(now - then) <= 1e-9 + 1e-6 * then)) {
                out.push_back(method + " " + setting + ": " + column + " was " + precise(then) + ", is " +
                              precise(now));
            }
        }
    }
    for (std::size_t row = 0; row < recorded.rows.size(); ++row) {
        const std::string method = recorded.cell(row, "method");
        const std::string setting = recorded.cell(row, "setting");
        if (fresh.find({{"method", method}, {"setting", setting}}) == fresh.rows.size()) {
            out.push_back(method + " " + setting + ": is recorded and not measured");
        }
    }
    return out;
}

}  // namespace study
