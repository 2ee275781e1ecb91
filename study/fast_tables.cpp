// Prints what the fast family of tables is worth: errors of single scattering with Hillaire's multiple
// scattering against the path tracer's table, and how long every table of the family takes to bake.

#include <airlight/atmospheres.hpp>
#include <airlight/tables/froxels.hpp>
#include <airlight/tables/hillaire.hpp>
#include <airlight/tables/sky_view.hpp>
#include <airlight/tables/transmittance.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "csv.hpp"
#include "error_metrics.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/machine.hpp"
#include "support/parallel.hpp"
#include "support/progress.hpp"

namespace {

using airlight::vec3;
using airlight::Viewpoint;

/// Enough nodes that what is left is the method's error.
struct ManyNodes : airlight::DefaultScene {
    static constexpr int nodes = 24;
};

/// A view of the path tracer's table.
struct TracedView {
    double altitude;
    double sun;  ///< degrees over the horizontal
    vec3<double> direction;
    vec3<double> to_sun;
    vec3<double> total;  ///< all orders, one number a channel
};

vec3<double> direction_at(double elevation, double azimuth) {
    const double degree = airlight::pi<double> / 180;
    const double level = std::cos(elevation * degree);
    return vec3<double>(level * std::cos(azimuth * degree), level * std::sin(azimuth * degree),
                        std::sin(elevation * degree));
}

/// Three lines of the table, one a channel, make a view.
std::vector<TracedView> traced_views(const std::string& path) {
    const study::Csv csv = study::read_csv(path);
    if (csv.rows.empty() || csv.rows.size() % 3 != 0) {
        throw support::Error(
            path + " has not three lines, one a channel, for each view: write it with path_trace --table");
    }
    std::vector<TracedView> views;
    for (std::size_t row = 0; row < csv.rows.size(); row += 3) {
        const double sun = csv.number(row, "sun_elevation");
        TracedView view = {csv.number(row, "altitude"), sun,
                           direction_at(csv.number(row, "elevation"), csv.number(row, "azimuth")),
                           direction_at(sun, 0), vec3<double>(0)};
        for (int channel = 0; channel < 3; ++channel) {
            view.total[channel] = csv.number(row + static_cast<std::size_t>(channel), "total");
        }
        views.push_back(view);
    }
    return views;
}

/// Light of a view by some method.
using Method = std::function<vec3<double>(const TracedView&)>;

void print_errors(const std::string& name, const std::vector<TracedView>& views, const Method& light) {
    std::vector<vec3<double>> got(views.size());
    support::ProgressBar bar(name);
    std::atomic<std::size_t> done{0};
    support::for_each_row(static_cast<int>(views.size()), [&](int row) {
        got[static_cast<std::size_t>(row)] = light(views[static_cast<std::size_t>(row)]);
        bar(++done, views.size());
    });
    std::string line = "| " + name + " |";
    const auto add = [&](double low, double high) {
        std::vector<double> errors;
        for (std::size_t i = 0; i < views.size(); ++i) {
            for (int channel = 0; channel < 3 && views[i].sun > low && views[i].sun <= high; ++channel) {
                errors.push_back(std::fabs(got[i][channel] / views[i].total[channel] - 1));
            }
        }
        const airlight_test::ErrorMetrics m = airlight_test::error_metrics(errors);
        char text[64];
        std::snprintf(text, sizeof text, " %.1f / %.1f / %.1f |", 100 * m.median, 100 * m.p95,
                      100 * m.largest);
        line += text;
    };
    add(0, 90);
    add(-6.5, 0);
    add(-90, -6.5);
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

/// A texel at every place that is asked for: the method without its table.
struct ComputedHillaire {
    const airlight::Atmosphere<double>* atmosphere;
    airlight::HillaireEffort effort;

    airlight::DiffuseLight<double> operator()(double altitude, double mu_s) const {
        return airlight::even_light(airlight::hillaire_texel<double>(
            *atmosphere, altitude, mu_s, effort.zeniths, effort.azimuths, effort.steps));
    }
};

void print_all_errors(const std::string& path) {
    const airlight::Atmosphere<double> air = airlight::earth<double>();
    const std::vector<TracedView> views = traced_views(path);
    airlight::Table<vec3<double>> table = airlight::bake_hillaire(air);
    airlight::Table<vec3<double>> roots = table;
    for (vec3<double>& texel : roots.texels) {
        texel = airlight::stored_light(texel);
    }
    const airlight::HillaireEffort fine = {24, 12, 100};
    const auto all = [&](const auto& hook) -> Method {
        return [&air, hook](const TracedView& view) {
            const Viewpoint<double> eye{view.altitude, vec3<double>(0, 0, 1)};
            return airlight::all_scattering<double, ManyNodes>(air, eye, view.direction, view.to_sun,
                                                               airlight::no_surface<double>(), hook)
                .radiance;
        };
    };
    std::printf(
        "Errors of each channel against %zu views of the path tracer, percent: median / 95 %% / largest.\n\n",
        views.size());
    std::printf("| method | sun up | 0 to -6 degrees | below |\n|---|---|---|---|\n");
    print_errors("once", views, all(airlight::NoDiffuseLight{}));
    print_errors("Hillaire, 32 x 32", views, all(airlight::HillaireLight<double>{&air, &table}));
    print_errors("Hillaire, 32 x 32 of square roots", views,
                 all(airlight::HillaireLight<double>{&air, &roots, true}));
    print_errors("Hillaire without a table", views, all(ComputedHillaire{&air, {}}));
    print_errors("the same, 576 directions of 100 steps", views, all(ComputedHillaire{&air, fine}));
}

/// Milliseconds of the fastest of some runs, by a clock of milliseconds.
template <typename Clock>
double fastest(const Clock& clock, const std::function<void()>& run) {
    double best = INFINITY;
    for (int i = 0; i < 7; ++i) {
        const double begun = clock();
        run();
        best = std::min(best, clock() - begun);
    }
    return best;
}

/// Of the processor, which other programs do not stop.
double processor_clock() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double wall_clock() {
    const std::chrono::duration<double, std::milli> now = std::chrono::steady_clock::now().time_since_epoch();
    return now.count();
}

struct EveryCore {
    template <typename Body>
    void operator()(int count, const Body& body) const {
        support::for_each_row(count, body);
    }
};

void print_bake_times() {
    using T = float;
    const airlight::Atmosphere<T> air = airlight::earth<T>();
    const airlight::Table<vec3<T>> hillaire = airlight::bake_hillaire(air);
    const airlight::HillaireLight<T> more{&air, &hillaire};
    const Viewpoint<T> eye{T(100), vec3<T>(T(0), T(0), T(1))};
    const airlight::CameraRays<T> camera = {vec3<T>(T(0), T(1), T(0)), vec3<T>(T(0.8L), T(0), T(0)),
                                            vec3<T>(T(0), T(0), T(0.45L))};
    const vec3<T> to_sun(T(0.8L), T(0), T(0.6L));
    std::printf("\nBaked in float on %s, milliseconds, the fastest of seven.\n\n",
                support::processor_name().c_str());
    std::printf("| table | one core, processor time | every core, by the clock |\n|---|---|---|\n");
    double alone = 0;
    double together = 0;
    const auto print = [&](const char* name, const auto& bake) {
        const double one = fastest(processor_clock, [&] { bake(airlight::OneAfterAnother{}); });
        const double every = fastest(wall_clock, [&] { bake(EveryCore{}); });
        alone += one;
        together += every;
        std::printf("| %s | %.1f | %.1f |\n", name, one, every);
    };
    print("slants 64 x 32", [&](const auto& rows) { airlight::bake_slants(air, 64, 32, rows); });
    print("Hillaire 32 x 32",
          [&](const auto& rows) { airlight::bake_hillaire(air, 32, 32, airlight::HillaireEffort{}, rows); });
    print("sky view 192 x 108, with Hillaire's", [&](const auto& rows) {
        airlight::bake_sky_view(air, eye.altitude, to_sun.z, 192, 108, more, rows);
    });
    print("froxels 32 x 32 x 32, with Hillaire's", [&](const auto& rows) {
        airlight::bake_froxels(air, eye, camera, to_sun, T(64e3L), airlight::FroxelSize{}, more, rows);
    });
    std::printf("| all of them | %.1f | %.1f |\n", alone, together);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Errors of Hillaire's multiple scattering against the path tracer, and bake times of the fast "
        "tables.",
        "fast_tables");
    std::string path = STUDY_REFERENCE;
    bool times_only = false;
    support::add_value(app, "--reference", "<file>", path,
                       "the path tracer's table (default: reference/data/earth.csv)");
    support::add_switch(app, "--times", times_only, "bake times alone");
    app.footer("Exit status: 0 done, 1 an error, 2 wrong use.");
    return support::guarded_main(app, argc, argv, [&] {
        if (!times_only) {
            print_all_errors(path);
        }
        print_bake_times();
        return 0;
    });
}
