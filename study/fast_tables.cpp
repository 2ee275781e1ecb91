// Prints what the fast family of tables is worth: errors of single scattering with Hillaire's multiple
// scattering against the path tracer's table, and how long every table of the family takes to bake.

#include <airlight/atmospheres.hpp>
#include <airlight/tables/froxels.hpp>
#include <airlight/tables/hillaire.hpp>
#include <airlight/tables/sky_view.hpp>
#include <airlight/tables/transmittance.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "error_metrics.hpp"
#include "path_traced.hpp"
#include "scenes.hpp"
#include "support/command_line.hpp"
#include "support/machine.hpp"
#include "support/rows.hpp"

namespace {

using airlight::vec3;
using airlight::Viewpoint;

using airlight_test::PathTraced;

/// Enough that what is left is the method's error.
using ManyNodes = airlight_test::Nodes<24>;

/// Light of a view by some method.
using Method = std::function<vec3<double>(const PathTraced&)>;

/// The views have three entries each, one a channel.
void print_errors(const std::string& name, const std::vector<PathTraced>& views, const Method& light) {
    std::vector<vec3<double>> got(views.size() / 3);
    const support::Rows rows(name);
    rows(static_cast<int>(got.size()), [&](int row) {
        const auto i = static_cast<std::size_t>(row);
        got[i] = light(views[3 * i]);
    });
    std::string line = "| " + name + " |";
    for (const airlight_test::SunClass& sun : airlight_test::sun_classes) {
        std::vector<double> errors;
        for (std::size_t i = 0; i < views.size(); ++i) {
            if (sun.holds(views[i])) {
                errors.push_back(std::fabs(got[i / 3][views[i].channel] / views[i].total - 1));
            }
        }
        const airlight_test::ErrorMetrics m = airlight_test::error_metrics(errors);
        char text[64];
        std::snprintf(text, sizeof text, " %.1f / %.1f / %.1f |", 100 * m.median, 100 * m.p95,
                      100 * m.largest);
        line += text;
    }
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
    const std::vector<PathTraced> views = airlight_test::read_path_traced(path);
    airlight::Table<vec3<double>> table = airlight::bake_hillaire(air);
    airlight::Table<vec3<double>> roots = table;
    for (vec3<double>& texel : roots.texels) {
        texel = airlight::stored_light(texel);
    }
    const airlight::HillaireEffort fine = {24, 12, 100};
    const auto all = [&](const auto& hook) -> Method {
        return [&air, hook](const PathTraced& view) {
            return airlight::all_scattering<double, ManyNodes>(
                       air, view.eye<double>(), view.direction<double>(), view.to_sun<double>(),
                       airlight::no_surface<double>(), hook)
                .radiance;
        };
    };
    std::printf(
        "Errors of each channel against %zu views of the path tracer, percent: median / 95 %% / largest.\n\n",
        views.size() / 3);
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
        const double every = fastest(wall_clock, [&] { bake(support::Rows{}); });
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
    std::string path = STUDY_ROOT "/reference/data/earth.csv";
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
