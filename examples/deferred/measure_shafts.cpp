// What each way to draw light shafts costs and how wrong it is, against a march of many steps through the
// same shadow maps. Writes a page in Markdown.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "renderer.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"
#include "support/machine.hpp"
#include "support/progress.hpp"

namespace deferred {
namespace {

constexpr int truth_steps = 3200;

struct Method {
    std::string name;
    Settings settings;
};

Settings shafts(Shafts kind) {
    Settings settings;
    settings.shafts = kind;
    return settings;
}

std::vector<Method> methods() {
    std::vector<Method> all;
    for (const int steps : {20, 80, 800}) {
        Settings s = shafts(Shafts::reference);
        s.reference_steps = steps;
        all.push_back({std::to_string(steps) + " even steps", s});
    }
    for (const auto& [pieces, looks] :
         {std::pair(4, 4), std::pair(8, 8), std::pair(12, 8), std::pair(16, 16)}) {
        for (const bool half : {false, true}) {
            Settings s = shafts(Shafts::march);
            s.shaft_pieces = pieces;
            s.shaft_looks = looks;
            s.half_shafts = half;
            all.push_back({"march, " + std::to_string(pieces) + " x " + std::to_string(looks) + " looks" +
                               (half ? ", half resolution" : ""),
                           s});
        }
    }
    for (const int slices : {128, 256, 512}) {
        Settings s = shafts(Shafts::epipolar);
        s.shaft_pieces = 8;
        s.shaft_slices = slices;
        s.shaft_samples = slices / 2;
        all.push_back(
            {"epipolar, " + std::to_string(slices) + " slices of " + std::to_string(slices / 2), s});
    }
    return all;
}

struct Sun {
    std::string camera;
    double elevation;
};

double at_rank(std::vector<double>& values, double share) {
    const std::size_t rank = std::size_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(rank), values.end());
    return values[rank];
}

void measure(int width, int height, const std::string& page) {
    const World world = worlds().front();
    const Terrain terrain(read_height_map(DEFERRED_HEIGHT_MAP, 74, 93));
    const AirTables tables = bake_tables(TableKind::none, world);
    const support::GlContext context;
    const std::vector<Sun> suns = {{"valley", 20}, {"valley", 12}, {"valley", 5}, {"ground", 5}, {"10km", 5}};
    const std::vector<Method> all = methods();

    std::vector<View> views;
    for (const Sun& sun : suns) {
        const auto camera = std::find_if(named_cameras().begin(), named_cameras().end(),
                                         [&sun](const Camera& c) { return c.name == sun.camera; });
        const Picturing picturing{width, height, sun.elevation, 250, false, 40, 12, Settings{}};
        views.push_back(make_view(*camera, picturing, double(world.atmosphere.ground_radius), terrain));
    }
    std::vector<std::vector<float>> truth;
    support::ProgressBar bar("light shafts");
    const std::size_t pictures = views.size() * (all.size() + 1);
    std::size_t done = 0;
    {
        Settings settings = shafts(Shafts::reference);
        settings.reference_steps = truth_steps;
        Renderer renderer(world, tables, terrain, settings, width, height);
        for (const View& view : views) {
            renderer.draw(view, settings);
            truth.push_back(renderer.read().radiance);
            bar(++done, pictures);
        }
    }
    std::ostringstream rows;
    for (const Method& method : all) {
        Renderer renderer(world, tables, terrain, method.settings, width, height);
        std::vector<double> errors;
        double milliseconds = 0;
        for (std::size_t v = 0; v < views.size(); ++v) {
            double fastest = std::numeric_limits<double>::infinity();
            GpuPicture picture;
            for (int run = 0; run < 2; ++run) {
                renderer.draw(views[v], method.settings);
                picture = renderer.read();
                fastest = std::min(fastest, picture.shaft_milliseconds);
            }
            milliseconds += fastest / double(views.size());
            for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
                // The sun's disc drowns the air around it.
                if (truth[v][i] < 10) {
                    errors.push_back(std::abs(double(picture.radiance[i]) - double(truth[v][i])) /
                                     std::max(double(truth[v][i]), 1e-9));
                }
            }
            bar(++done, pictures);
        }
        char line[256];
        const double middle = at_rank(errors, 0.5);
        const double most = at_rank(errors, 0.95);
        std::snprintf(line, sizeof line, "| %s | %.3g | %.3g | %.3g | %.3g |\n", method.name.c_str(),
                      100 * middle, 100 * most, 100 * *std::max_element(errors.begin(), errors.end()),
                      milliseconds);
        rows << line;
    }
    std::ostringstream text;
    text << "# Light shafts: error and cost\n\n"
         << "Light of pixels of " << width << " x " << height << " against a march of " << truth_steps
         << " even steps through the same shadow maps,\nrelative to the pixel's own radiance, single "
            "scattering, three "
            "channels, over\n"
         << views.size() << " views of `deferred` (";
    for (std::size_t v = 0; v < suns.size(); ++v) {
        text << (v == 0 ? "" : ", ") << suns[v].camera << " " << suns[v].elevation;
    }
    text << " degrees).\nMilliseconds of the shafts' passes alone, the faster of two runs, mean of the "
            "views, on\n"
         << context.renderer() << ", " << support::processor_name()
         << ".\nWritten by `measure_shafts --write docs/shafts.md`.\n\n"
         << "The worst pixels lie where the sun's aureole is all but covered, and what is left is a small "
            "difference.\n\n"
         << "| method | median, % | 95 % within, % | worst, % | ms |\n|---|---|---|---|---|\n"
         << rows.str();
    if (page.empty()) {
        std::cout << text.str();
    } else {
        support::write_file(page, text.str());
    }
}

}  // namespace
}  // namespace deferred

int main(int count, char** arguments) {
    CLI::App app("Measures what each way to draw light shafts costs and how wrong it is.");
    app.set_help_flag("--help", "Print this and stop");
    int width = 320;
    int height = 180;
    std::string page;
    app.add_option("--width", width, "Pixels; 320 if not given")->check(CLI::Range(16, 4096));
    app.add_option("--height", height, "Pixels; 180 if not given")->check(CLI::Range(16, 4096));
    app.add_option("--write", page, "The Markdown page to write; standard output if not given");
    CLI11_PARSE(app, count, arguments);
    try {
        deferred::measure(width, height, page);
        return 0;
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << "measure_shafts: " << error.what() << "\n";
        return 1;
    }
}
