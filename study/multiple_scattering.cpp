// The price list of multiple scattering: what each way of having it costs in texels, time to bake and time a
// view ray, and how wrong it is against the path tracer's views of the library's Earth.

#include <CLI/CLI.hpp>
#include <airlight/atmospheres.hpp>
#include <airlight/color.hpp>
#include <airlight/tables/bruneton.hpp>
#include <airlight/tables/diffuse.hpp>
#include <airlight/tables/hillaire.hpp>
#include <airlight/tables/inscatter.hpp>
#include <airlight/tables/transmittance.hpp>
#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "csv.hpp"
#include "error_metrics.hpp"
#include "path_traced.hpp"
#include "scenes.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/image.hpp"
#include "support/machine.hpp"
#include "support/parallel.hpp"
#include "support/rows.hpp"

namespace {

using airlight_test::Nodes;
using airlight_test::PathTraced;

/// A panorama of the sky over the ground by the path tracer: the sun's side in the middle, the zenith on top.
struct Panorama {
    double sun = 0;  ///< [degrees] elevation
    int width = 0;
    int height = 0;  ///< from the zenith to the horizon
    std::vector<airlight::vec3<float>> pixels;
};

struct Settings {
    std::string table = STUDY_ROOT "/reference/data/earth.csv";
    std::string write;
    std::string page;
    std::string pictures;          ///< a folder
    std::vector<Panorama> traced;  ///< what pictures are compared with
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
    std::vector<Panorama> panoramas;
    std::string method;
    std::string scalar;
    std::string size;
    int orders = 0;
    double seconds = 0;                       ///< of the bake, on all cores
    std::size_t numbers = 0;                  ///< in all tables that the way reads
    double cost = 0;                          ///< of a view ray, of that of single_scattering
    double cycles = 0;                        ///< of 64 view rays on a GPU; 0 where nobody counted them
    airlight_test::ErrorMetrics all[3];       ///< against all orders of the path tracer, by class of sun
    airlight_test::ErrorMetrics the_same[3];  ///< against its first `orders`
};

PathTraced view_of_pixel(const Panorama& panorama, int x, int y) {
    PathTraced view{};
    view.altitude = 2;
    view.sun_elevation = panorama.sun;
    view.elevation = 90 - (y + 0.5) * 90 / panorama.height;
    view.azimuth = (x + 0.5) * 360 / panorama.width - 180;
    return view;
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

template <typename T>
constexpr const char* scalar_name = sizeof(T) == 4 ? "float" : "double";

/// Seconds for the light of every view, the best of a few rounds.
template <typename Light>
double seconds_of(const std::vector<PathTraced>& views, const Light& light) {
    double best = 1e30;
    double kept = 0;
    for (int round = 0; round < 7; ++round) {
        const auto begun = Clock::now();
        for (int repeat = 0; repeat < 20; ++repeat) {
            for (std::size_t i = 0; i < views.size(); i += 3) {  // three channels each
                kept += static_cast<double>(light(views[i])[1]);
            }
        }
        best = std::min(best, seconds_since(begun));
    }
    return kept < 0 ? 0 : best;
}

template <typename T>
airlight::vec3<T> scattered_once(const airlight::Atmosphere<T>& air, const PathTraced& view) {
    return airlight::single_scattering<T>(air, view.eye<T>(), view.direction<T>(), view.to_sun<T>(),
                                          airlight::no_surface<T>())
        .radiance;
}

/// Cycles of 64 rays on a GPU, the sum of functions in the table of shader_cost.
double gpu_cycles(const std::vector<std::map<std::string, std::string>>& functions) {
    static const char* const path = STUDY_ROOT "/bench/shader_cost/results.csv";
    static const study::Csv prices = study::read_csv(path);
    double cycles = 0;
    for (const auto& function : functions) {
        const std::size_t row = prices.find(function);
        if (row == prices.rows.size()) {
            throw support::Error(std::string(path) + " has no '" + function.at("method") +
                                 "' as the study asks for it; measure anew: shader_cost --write");
        }
        cycles += prices.number(row, "inverse_throughput_cycles");
    }
    return cycles;
}

/// Of all_scattering by a table.
double gpu_cycles_with(const std::string& table, const std::string& nodes) {
    return gpu_cycles({{{"method", "single_scattering"}, {"setting", nodes}, {"flags", "default"}},
                       {{"method", "diffuse_scattering"}, {"setting", nodes}, {"flags", "table=" + table}}});
}

template <typename T, typename Light>
void judge(Result& result, const Settings& settings, const std::vector<PathTraced>& views,
           const Light& light) {
    const airlight::Atmosphere<T> earth = airlight::earth<T>();
    result.cost = seconds_of(views, light) /
                  seconds_of(views, [&](const PathTraced& view) { return scattered_once<T>(earth, view); });
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
    result.panoramas.clear();
    for (Panorama panorama : settings.traced) {
        support::for_each_row(panorama.height, [&](int y) {
            for (int x = 0; x < panorama.width; ++x) {
                const airlight::vec3<T> seen = light(view_of_pixel(panorama, x, y));
                panorama.pixels[static_cast<std::size_t>(y * panorama.width + x)] = airlight::vec3<float>(
                    static_cast<float>(seen.x), static_cast<float>(seen.y), static_cast<float>(seen.z));
            }
        });
        result.panoramas.push_back(panorama);
    }
}

/// The ways of using one bake: all of it, its first order alone, and its higher orders with order 1 by nodes.
template <typename T, typename Shape>
void add(std::vector<Result>& results, const std::string& name, const std::string& gpu_name,
         const Shape& shape, const Settings& settings, const std::vector<PathTraced>& views) {
    using Scene = Nodes<16>;
    using Hook = airlight::TableHook<T, Shape>;
    const std::string scalar = scalar_name<T>;
    if (!settings.only.empty() && (name + " " + scalar).find(settings.only) == std::string::npos) {
        return;
    }
    const auto begun = Clock::now();
    airlight::ScatteringTables<T> tables;
    {
        const support::Rows rows(name + ", " + scalar);
        rows.expect_passes(airlight::passes_of_bake(settings.orders));
        tables = airlight::bake_scattering<Scene>(shape, settings.orders, rows);
    }
    Result result;
    result.scalar = scalar;
    result.size = std::to_string(shape.width()) + " x " + std::to_string(shape.height()) + " x " +
                  std::to_string(shape.depth());
    result.seconds = seconds_since(begun);
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
    const airlight::NothingScattered nothing;

    result.method = name + ", order 1 alone";
    result.orders = 1;
    result.numbers = 2 * 3 * texels;
    judge<T>(result, settings, views,
             [&](const PathTraced& view) { return from_table(view, rayleigh, mie, nothing); });
    results.push_back(result);

    result.method = name;
    result.orders = settings.orders;
    result.numbers = 3 * 3 * texels;
    result.cycles = gpu_cycles({{{"method", "scattering_of_table"}, {"flags", "table=" + gpu_name}}});
    judge<T>(result, settings, views,
             [&](const PathTraced& view) { return from_table(view, rayleigh, mie, multiple); });
    results.push_back(result);

    result.method = name + ", order 1 by 8 nodes";
    result.numbers = 3 * texels;
    result.cycles = 0;
    judge<T>(result, settings, views, [&](const PathTraced& view) {
        return from_table(view, nothing, nothing, multiple) + scattered_once<T>(shape.atmosphere, view);
    });
    results.push_back(result);
}

template <typename T>
void add_without_table(std::vector<Result>& results, const Settings& settings,
                       const std::vector<PathTraced>& views) {
    const airlight::Atmosphere<T> earth = airlight::earth<T>();
    Result result;
    result.method = "single_scattering, 8 nodes";
    result.scalar = scalar_name<T>;
    result.size = "none";
    result.orders = 1;
    result.cycles = gpu_cycles({{{"method", "single_scattering"}, {"setting", "8"}, {"flags", "default"}}});
    judge<T>(result, settings, views, [&](const PathTraced& view) { return scattered_once<T>(earth, view); });
    results.push_back(result);
}

/// Light scattered once by a march, with the sun's light from the table of slants: what a table alone gives.
template <typename T>
void add_march(std::vector<Result>& results, const Settings& settings, const std::vector<PathTraced>& views) {
    const airlight::Atmosphere<T> earth = airlight::earth<T>();
    constexpr int steps = 64;
    Result result;
    result.method = "march of " + std::to_string(steps) + " steps, slants";
    result.scalar = scalar_name<T>;
    result.size = "64 x 32";
    result.orders = 1;
    result.numbers = 2 * 64 * 32;
    const auto begun = Clock::now();
    const airlight::Table<airlight::vec2<T>> slants = airlight::bake_slants<T>(earth, 64, 32);
    result.seconds = seconds_since(begun);
    judge<T>(result, settings, views, [&](const PathTraced& view) {
        return airlight::single_scattering_marched<T>(
                   earth, view.eye<T>(), view.direction<T>(), view.to_sun<T>(), airlight::no_surface<T>(),
                   steps, airlight::AlwaysLit{}, airlight::SlantTransmittance<T>{&slants})
            .radiance;
    });
    results.push_back(result);
}

/// All orders are meant where a series stands for the last.
constexpr int every_order = 12;

/// A table of light from all sides, of some kind, on top of single_scattering.
template <typename T, int NodeCount, typename Bake>
void add_light_from_all_sides(std::vector<Result>& results, const std::string& name, const std::string& size,
                              const std::string& gpu_name, std::size_t numbers, const Bake& bake,
                              const Settings& settings, const std::vector<PathTraced>& views) {
    const airlight::Atmosphere<T> earth = airlight::earth<T>();
    Result result;
    result.method = name + ", " + std::to_string(NodeCount) + " nodes";
    result.scalar = scalar_name<T>;
    result.size = size;
    result.orders = every_order;
    result.numbers = numbers;
    result.cycles = gpu_cycles_with(gpu_name, std::to_string(NodeCount));
    const auto begun = Clock::now();
    const auto light = bake(earth);
    result.seconds = seconds_since(begun);
    judge<T>(result, settings, views, [&](const PathTraced& view) {
        return airlight::all_scattering<T, Nodes<NodeCount>>(earth, view.eye<T>(), view.direction<T>(),
                                                             view.to_sun<T>(), airlight::no_surface<T>(),
                                                             light)
            .radiance;
    });
    results.push_back(result);
}

template <typename T>
void add_small_tables(std::vector<Result>& results, const Settings& settings,
                      const std::vector<PathTraced>& views) {
    using Air = airlight::Atmosphere<T>;
    const support::Rows rows;
    airlight::Table<airlight::vec3<T>> hillaire;
    add_light_from_all_sides<T, 8>(
        results, "Hillaire", "32 x 32", "hillaire", 3 * 32 * 32,
        [&](const Air& air) {
            hillaire = airlight::bake_hillaire<T>(air, 32, 32, {}, rows);
            return airlight::HillaireLight<T>{&air, &hillaire};
        },
        settings, views);
    const auto layers = static_cast<std::size_t>(airlight::diffuse_table_layers);
    const auto small = [&](const Air& air) {
        return airlight::bake_diffuse_table<T, Nodes<6>>(air, 32, 8, 4, rows);
    };
    add_light_from_all_sides<T, 4>(results, "diffuse table, small and quick", "32 x 8 x 10", "diffuse",
                                   4 * 32 * 8 * layers, small, settings, views);
    add_light_from_all_sides<T, 8>(results, "diffuse table, small and quick", "32 x 8 x 10", "diffuse",
                                   4 * 32 * 8 * layers, small, settings, views);
    add_light_from_all_sides<T, 8>(
        results, "diffuse table", "64 x 16 x 10", "diffuse", 4 * 64 * 16 * layers,
        [&](const Air& air) { return airlight::bake_diffuse_table<T, Nodes<8>>(air, 64, 16, 6, rows); },
        settings, views);
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
    add<T>(results, "altitude, view, sun", "inscatter3d", three, settings, views);
    add<T>(results, "Bruneton", "bruneton", four, settings, views);
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", 100 * share);
    return text;
}

/// The price list in Markdown: against all orders, or against the method's own.
std::string price_list(const std::vector<Result>& results, int cores, bool same_orders) {
    std::string text = "| method | scalar | texels | kB in 16 bits | bake, s on " + std::to_string(cores) +
                       " cores | time a ray | GPU cycles";
    for (const airlight_test::SunClass& sun : airlight_test::sun_classes) {
        text += std::string(" | ") + sun.name + ": median, p95, max %";
    }
    text += " |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Result& result : results) {
        char numbers[96];
        std::snprintf(numbers, sizeof numbers, "%.0f | %.2f | %.1f",
                      2e-3 * static_cast<double>(result.numbers), result.seconds, result.cost);
        text += "| " + result.method +
                (result.orders < every_order && result.orders > 1
                     ? ", " + std::to_string(result.orders) + " orders"
                     : "") +
                " | " + result.scalar + " | " + result.size + " | " + numbers + " | " +
                (result.cycles > 0 ? std::to_string(std::lround(result.cycles)) : "-");
        for (const auto& error : same_orders ? result.the_same : result.all) {
            text += " | " + percent(error.median) + ", " + percent(error.p95) + ", " + percent(error.largest);
        }
        text += " |\n";
    }
    return text;
}

std::string csv(const std::vector<Result>& results) {
    std::string text =
        "method,scalar,size,orders,numbers,bake_seconds,time_a_ray,gpu_cycles,against,sun,median,p95,max\n";
    for (const Result& result : results) {
        for (const bool same : {false, true}) {
            for (int sun = 0; sun < 3; ++sun) {
                const airlight_test::ErrorMetrics& error = same ? result.the_same[sun] : result.all[sun];
                char numbers[128];
                std::snprintf(numbers, sizeof numbers, "%.6g,%.6g,%.6g", error.median, error.p95,
                              error.largest);
                text += "\"" + result.method + "\"," + result.scalar + "," + result.size + "," +
                        std::to_string(result.orders) + "," + std::to_string(result.numbers) + "," +
                        std::to_string(result.seconds) + "," + std::to_string(result.cost) + "," +
                        std::to_string(std::lround(result.cycles)) + "," +
                        (same ? "the same orders" : "all orders") + "," +
                        airlight_test::sun_classes[sun].name + "," + numbers + "\n";
            }
        }
    }
    return text;
}

/// The path tracer's panoramas of the committed data, their upper half.
std::vector<Panorama> read_panoramas() {
    std::vector<Panorama> out;
    for (const double sun : {5.0, -4.0}) {
        char name[64];
        std::snprintf(name, sizeof name, "/reference/data/sky_sun%+g.exr", sun);
        const support::ExrImage image = support::read_exr(std::string(STUDY_ROOT) + name);
        Panorama panorama{sun, image.width, image.height / 2, {}};
        panorama.pixels.resize(static_cast<std::size_t>(panorama.width * panorama.height));
        for (int c = 0; c < 3; ++c) {
            const std::string wanted(1, "RGB"[c]);
            const support::ExrChannel* const channel = support::find_channel(image, wanted);
            if (channel == nullptr) {
                throw support::Error(std::string(name) + " has no channel " + wanted);
            }
            for (std::size_t i = 0; i < panorama.pixels.size(); ++i) {
                panorama.pixels[i][c] = channel->pixels[i];
            }
        }
        out.push_back(std::move(panorama));
    }
    return out;
}

constexpr int magnified = 4;

template <typename Color>
void write_magnified(const std::string& path, const Panorama& panorama, const Color& color_of) {
    support::Picture picture{panorama.width * magnified, panorama.height * magnified, {}};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const airlight::vec3<float> color =
                color_of(static_cast<std::size_t>(y / magnified * panorama.width + x / magnified));
            for (int c = 0; c < 3; ++c) {
                picture.pixels.push_back(
                    static_cast<std::uint8_t>(255 * glm::clamp(color[c], 0.0F, 1.0F) + 0.5F));
            }
        }
    }
    support::write_png(path, picture);
}

/// Each method's sky in float, and its difference from the path tracer's: white where they agree, red where
/// it is brighter, blue where it is darker, full at 20 %.
void write_pictures(const Settings& settings, const std::vector<Result>& results) {
    support::make_writable_directory(settings.pictures);
    const auto write = [&](const std::string& name, const Panorama& panorama, const Panorama& truth) {
        char sun[32];
        std::snprintf(sun, sizeof sun, "_sun%+g", panorama.sun);
        const std::string base = settings.pictures + "/" + name + sun;
        const float exposure = panorama.sun > 0 ? 20.0F : 600.0F;
        write_magnified(base + ".png", panorama, [&](std::size_t i) {
            const airlight::vec3<float> shown = airlight::exposed(panorama.pixels[i], exposure);
            return airlight::srgb_from_linear(shown);
        });
        write_magnified(base + "_error.png", panorama, [&](std::size_t i) {
            const float got = airlight::luminance(panorama.pixels[i]);
            const float expected = std::max(airlight::luminance(truth.pixels[i]), 1e-12F);
            const float off = glm::clamp((got / expected - 1) / 0.2F, -1.0F, 1.0F);
            return off > 0 ? airlight::vec3<float>(1, 1 - off, 1 - off)
                           : airlight::vec3<float>(1 + off, 1 + off, 1);
        });
    };
    for (const Panorama& truth : settings.traced) {
        write("path_traced", truth, truth);
    }
    for (const Result& result : results) {
        if (result.scalar != "float") {
            continue;
        }
        std::string name;
        for (const char c : result.method) {
            name += std::isalnum(static_cast<unsigned char>(c)) != 0
                        ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                        : '_';
        }
        for (std::size_t i = 0; i < result.panoramas.size(); ++i) {
            write(name, result.panoramas[i], settings.traced[i]);
        }
    }
}

std::string page(const std::vector<Result>& results, int cores) {
    return "# What multiple scattering costs, and how wrong it is\n\nWritten by `study/run` (" +
           support::processor_name() + ", " + std::to_string(cores) + " cores). Do not edit." + R"(

Sky radiance of the library's Earth, each of three channels, against the path tracer's light of all orders in
`reference/data/earth.csv`, where its own errors stand too: zenith, horizon, between, from 10 km, disc and limb from an
orbit. Time is that of a view ray on one core, of that of `single_scattering` with 8 nodes. GPU cycles are those of 64 view
rays, by `shader_cost`, see [bench](../bench/README.md); a dash where they were not counted. Texels are counted in all the
tables that a ray reads.

)" + price_list(results, cores, false) +
           R"(
The sky over the ground with the sun 5 degrees up and 4 degrees down, and under each how far it is off the path tracer's:
white where they agree, red brighter, blue darker, full at 20 %. What is left in white is the path tracer's own noise.

![Skies](../study/results/skies.png)

The same against no more orders than the method has: what its table and its quadratures are worth, without the orders
that it leaves out.

)" + price_list(results, cores, true);
}

int run(Settings settings) {
    const std::vector<PathTraced> views = airlight_test::read_path_traced(settings.table);
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    if (!settings.pictures.empty()) {
        settings.traced = read_panoramas();
    }
    std::vector<Result> results;
    add_without_table<float>(results, settings, views);
    add_march<float>(results, settings, views);
    if (settings.only.empty() || settings.only == "small") {
        add_small_tables<float>(results, settings, views);
        add_small_tables<double>(results, settings, views);
    }
    if (settings.only != "small") {
        add_all<float>(results, settings, views);
        if (settings.only.find("double") != std::string::npos) {
            add_all<double>(results, settings, views);  // the same to the printed digits, in twice the time
        }
    }
    std::cout << price_list(results, cores, false) << "\nagainst the same orders\n\n"
              << price_list(results, cores, true);
    if (!settings.write.empty()) {
        support::write_file(settings.write, csv(results));
    }
    if (!settings.pictures.empty()) {
        write_pictures(settings, results);
    }
    if (!settings.page.empty()) {
        support::write_file(settings.page, page(results, cores));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    CLI::App app(
        "The price list of multiple scattering: errors against the path tracer's views beside texels and "
        "time.",
        "multiple_scattering");
    support::add_value(app, "--orders", "<count>", settings.orders, "of scattering, 1 or more (default 4)")
        ->check(CLI::Range(1, 1000));
    support::add_value(app, "--only", "<text>", settings.only,
                       "tables whose name and scalar hold this: 'sun float', 'Bruneton', 'double'; or small: "
                       "light from all sides alone, seconds");
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
                       "that the tables know, as -12 (default: where the last light is gone, -30)")
        ->check(CLI::Range(-90.0, -1.0));
    support::add_switch(app, "--quick", settings.quick, "small tables: does it run?");
    support::add_value(app, "--write", "<file>", settings.write, "the figures as CSV");
    support::add_value(app, "--page", "<file>", settings.page, "the price list as a page");
    support::add_value(app, "--pictures", "<folder>", settings.pictures,
                       "each method's sky beside the path tracer's, and how far it is off, as PNG");
    support::add_value(app, "--reference", "<file>", settings.table,
                       "the path tracer's table (default: the committed one)");
    app.footer(
        "Default sizes are Bruneton's; all of it takes minutes on two cores.\nExit status: 0 done, 1 failed, "
        "2 wrong use.");
    return support::guarded_main(app, argc, argv, [&] { return run(settings); });
}
