// What tables of scattered light are worth: the three- and the four-dimensional table, with the orders that
// one wants, against the path tracer's views of the library's Earth.

#include <CLI/CLI.hpp>
#include <airlight/atmospheres.hpp>
#include <airlight/tables/bruneton.hpp>
#include <airlight/tables/inscatter.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bake_tables/rows.hpp"
#include "error_metrics.hpp"
#include "path_traced.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"

namespace {

using airlight_test::PathTraced;

/// Samples on a leg of a ray, and polar angles of half a sphere.
template <int Count>
struct Nodes : airlight::DefaultScene {
    static constexpr int nodes = Count;
};

struct Settings {
    std::string table = STUDY_ROOT "/reference/data/earth.csv";
    std::string write;
    std::string only;
    int orders = 4;
    int altitudes = 32;
    int views = 128;
    int suns = 0;  ///< 0: 64 in three dimensions, 32 in four
    int nus = 8;
    double lowest_sun = -90;  ///< [degrees] -90: lowest_sun_cosine's
    bool quick = false;
};

/// What one way of computing the sky is worth.
struct Result {
    std::string method;
    std::string scalar;
    std::string size;
    int orders = 0;
    double seconds = 0;                       ///< of the bake, on all cores
    std::size_t texels = 0;                   ///< of all tables that the way reads
    airlight_test::ErrorMetrics all[3];       ///< against all orders of the path tracer, by class of sun
    airlight_test::ErrorMetrics the_same[3];  ///< against its first `orders`
};

template <typename Light>
void judge(Result& result, const std::vector<PathTraced>& views, const Light& light) {
    for (int sun = 0; sun < 3; ++sun) {
        std::vector<double> all;
        std::vector<double> the_same;
        for (const PathTraced& view : views) {
            if (airlight_test::sun_classes[sun].holds(view)) {
                const double got = static_cast<double>(light(view)[view.channel]);
                all.push_back(std::fabs(got / view.total - 1));
                // Views that the first orders leave dark are held against a thousandth of all their light.
                const double same =
                    std::max(view.sum_of_orders(1, std::min(result.orders, 12)), 1e-3 * view.total);
                the_same.push_back(std::fabs(got - same) / same);
            }
        }
        result.all[sun] = airlight_test::error_metrics(all);
        result.the_same[sun] = airlight_test::error_metrics(the_same);
    }
}

/// The ways of using one bake: all of it, its first order alone, and its higher orders with order 1 by nodes.
template <typename T, typename Shape>
void add(std::vector<Result>& results, const std::string& name, const Shape& shape, const Settings& settings,
         const std::vector<PathTraced>& views) {
    using Scene = Nodes<16>;
    using Hook = airlight::TableHook<T, Shape>;
    const std::string scalar = sizeof(T) == 4 ? "float" : "double";
    if (!settings.only.empty() && (name + " " + scalar).find(settings.only) == std::string::npos) {
        return;
    }
    const auto begun = std::chrono::steady_clock::now();
    airlight::ScatteringTables<T> tables;
    {
        const bake_tables::Rows rows(name + ", " + scalar);
        rows.expect_passes(airlight::passes_of_bake(settings.orders));
        tables = airlight::bake_scattering<Scene>(shape.atmosphere, shape, settings.orders, rows);
    }
    Result result;
    result.scalar = scalar;
    result.size = std::to_string(shape.width()) + " x " + std::to_string(shape.height()) + " x " +
                  std::to_string(shape.depth());
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const std::size_t texels = tables.rayleigh.texels.size();

    const auto from_table = [&](const PathTraced& view, const auto& rayleigh, const auto& mie,
                                const auto& multiple) {
        return airlight::scattering_of_table<T, Scene>(shape.atmosphere, view.eye<T>(), view.direction<T>(),
                                                       view.to_sun<T>(), airlight::no_surface<T>(), rayleigh,
                                                       mie, multiple)
            .radiance;
    };
    const Hook rayleigh{shape, tables.rayleigh};
    const Hook mie{shape, tables.mie};
    const Hook multiple{shape, tables.multiple};
    const airlight::NothingAlongRay nothing;

    result.method = name + ", order 1 alone";
    result.orders = 1;
    result.texels = 2 * texels;
    judge(result, views, [&](const PathTraced& view) { return from_table(view, rayleigh, mie, nothing); });
    results.push_back(result);

    result.method = name;
    result.orders = settings.orders;
    result.texels = 3 * texels;
    judge(result, views, [&](const PathTraced& view) { return from_table(view, rayleigh, mie, multiple); });
    results.push_back(result);

    result.method = name + ", order 1 by 8 nodes";
    result.texels = texels;
    judge(result, views, [&](const PathTraced& view) {
        return from_table(view, nothing, nothing, multiple) +
               airlight::single_scattering<T>(shape.atmosphere, view.eye<T>(), view.direction<T>(),
                                              view.to_sun<T>(), airlight::no_surface<T>())
                   .radiance;
    });
    results.push_back(result);
}

void add_without_table(std::vector<Result>& results, const std::vector<PathTraced>& views) {
    const airlight::Atmosphere<double> earth = airlight::earth<double>();
    Result result;
    result.method = "single_scattering, 8 nodes";
    result.scalar = "double";
    result.size = "none";
    result.orders = 1;
    judge(result, views, [&](const PathTraced& view) {
        return airlight::single_scattering<double>(earth, view.eye<double>(), view.direction<double>(),
                                                   view.to_sun<double>(), airlight::no_surface<double>())
            .radiance;
    });
    results.push_back(result);
}

template <typename T>
void add_all(std::vector<Result>& results, const Settings& settings, const std::vector<PathTraced>& views) {
    airlight::InscatterShape<T> three{airlight::earth<T>()};
    airlight::BrunetonShape<T> four{airlight::earth<T>()};
    three.altitudes = four.altitudes = settings.quick ? 8 : settings.altitudes;
    three.views = four.views = settings.quick ? 24 : settings.views;
    four.nus = settings.quick ? 4 : settings.nus;
    if (settings.quick || settings.suns > 0) {
        three.suns = four.suns = settings.quick ? 12 : settings.suns;
    }
    if (settings.lowest_sun > -90) {
        three.lowest_sun = four.lowest_sun = T(std::sin(settings.lowest_sun * airlight::pi<double> / 180));
    }
    add<T>(results, "altitude, view, sun", three, settings, views);
    add<T>(results, "Bruneton", four, settings, views);
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", 100 * share);
    return text;
}

void print(const std::vector<Result>& results, int cores) {
    std::cout << "| tables | scalar | size | orders | bake, s on " << cores
              << " cores | errors in %, against";
    for (const airlight_test::SunClass& sun : airlight_test::sun_classes) {
        std::cout << " | " << sun.name << ": median, p95, max";
    }
    std::cout << " |\n|---|---|---|---|---|---|---|---|---|\n";
    for (const Result& result : results) {
        for (const bool same : {false, true}) {
            char seconds[32];
            std::snprintf(seconds, sizeof seconds, "%.1f", result.seconds);
            std::cout << "| " << result.method << " | " << result.scalar << " | " << result.size << " | "
                      << result.orders << " | " << seconds << " | "
                      << (same ? "the same orders" : "all orders");
            for (const auto& error : same ? result.the_same : result.all) {
                std::cout << " | " << percent(error.median) << ", " << percent(error.p95) << ", "
                          << percent(error.largest);
            }
            std::cout << " |\n";
        }
    }
}

std::string csv(const std::vector<Result>& results) {
    std::string text = "method,scalar,size,orders,texels,bake_seconds,against,sun,median,p95,max\n";
    for (const Result& result : results) {
        for (const bool same : {false, true}) {
            for (int sun = 0; sun < 3; ++sun) {
                const airlight_test::ErrorMetrics& error = same ? result.the_same[sun] : result.all[sun];
                char numbers[128];
                std::snprintf(numbers, sizeof numbers, "%.6g,%.6g,%.6g", error.median, error.p95,
                              error.largest);
                text += "\"" + result.method + "\"," + result.scalar + "," + result.size + "," +
                        std::to_string(result.orders) + "," + std::to_string(result.texels) + "," +
                        std::to_string(result.seconds) + "," + (same ? "the same orders" : "all orders") +
                        "," + airlight_test::sun_classes[sun].name + "," + numbers + "\n";
            }
        }
    }
    return text;
}

int run(const Settings& settings) {
    const std::vector<PathTraced> views = airlight_test::read_path_traced(settings.table);
    std::vector<Result> results;
    add_without_table(results, views);
    add_all<float>(results, settings, views);
    add_all<double>(results, settings, views);
    print(results, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    if (!settings.write.empty()) {
        support::write_file(settings.write, csv(results));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    CLI::App app(
        "Errors of tables of scattered light against the path tracer's views, and the time of their bakes.",
        "scattering_tables");
    support::add_value(app, "--orders", "<count>", settings.orders, "of scattering, 1 or more (default 4)")
        ->check(CLI::Range(1, 1000));
    support::add_value(app, "--only", "<text>", settings.only,
                       "tables whose name and scalar hold this: 'sun float', 'Bruneton', 'double'");
    support::add_value(app, "--altitudes", "<count>", settings.altitudes, "of the tables (default 32)")
        ->check(CLI::Range(2, 1024));
    const CLI::Validator even(
        [](std::string& text) {
            int count = 0;
            return CLI::detail::lexical_cast(text, count) && count >= 4 && count <= 4096 && count % 2 == 0
                       ? std::string()
                       : "needs an even number from 4 to 4096, not '" + text + "'";
        },
        "");
    support::add_value(app, "--views", "<count>", settings.views, "half of them to the ground (default 128)")
        ->check(even);
    support::add_value(app, "--suns", "<count>", settings.suns,
                       "(default 64 in three dimensions, 32 in four)")
        ->check(CLI::Range(2, 1024));
    support::add_value(app, "--nus", "<count>", settings.nus, "angles between view and sun (default 8)")
        ->check(CLI::Range(2, 256));
    support::add_value(app, "--lowest-sun", "<degrees>", settings.lowest_sun,
                       "that the tables know, as -12 (default: where the last light is gone, -20)")
        ->check(CLI::Range(-90.0, -1.0));
    support::add_switch(app, "--quick", settings.quick, "small tables: does it run?");
    support::add_value(app, "--write", "<file>", settings.write, "the figures as CSV");
    support::add_value(app, "--reference", "<file>", settings.table,
                       "the path tracer's table (default: the committed one)");
    app.footer(
        "Default sizes are Bruneton's; all of it takes minutes on two cores.\nExit status: 0 done, 1 failed, "
        "2 wrong use.");
    return support::guarded_main(app, argc, argv, [&] { return run(settings); });
}
