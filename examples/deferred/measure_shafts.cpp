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

#include <airlight/constants.hpp>

#include "by_name.hpp"
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

/// The pixel that is off by most, relative to its own light.
struct Worst {
    double error = 0;
    std::size_t view = 0;
    double degrees_from_sun = 0;
    double left = 1;  ///< of its light without shadows
};

double degrees_from_sun(const Frame& frame, int pixel) {
    const glm::dvec3 ray(frame.ray_corner + (float(pixel % frame.width) + 0.5f) * frame.ray_across +
                         (float(pixel / frame.width) + 0.5f) * frame.ray_up);
    const glm::dvec3 to_sun(to_mapped_light(frame));
    return std::atan2(glm::length(glm::cross(ray, to_sun)), glm::dot(ray, to_sun)) * 180 /
           airlight::pi<double>;
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
        const Picturing picturing{width, height, sun.elevation, 250, false, 40, 12, Settings{}};
        views.push_back(make_view(by_name(named_cameras(), sun.camera, "camera"), picturing,
                                  double(world.atmosphere.ground_radius), terrain));
    }
    support::ProgressBar bar("light shafts");
    const std::size_t pictures = views.size() * (all.size() + 2);
    std::size_t done = 0;
    const auto radiances = [&](const Settings& settings) {
        std::vector<std::vector<float>> radiance;
        Renderer renderer(world, tables, terrain, settings, width, height);
        for (const View& view : views) {
            renderer.draw(view, settings);
            radiance.push_back(renderer.read().radiance);
            bar(++done, pictures);
        }
        return radiance;
    };
    const std::vector<std::vector<float>> unshaded = radiances(shafts(Shafts::none));
    Settings exact = shafts(Shafts::reference);
    exact.reference_steps = truth_steps;
    const std::vector<std::vector<float>> truth = radiances(exact);
    std::ostringstream rows;
    for (const Method& method : all) {
        Renderer renderer(world, tables, terrain, method.settings, width, height);
        std::vector<double> errors;
        double milliseconds = 0;
        Worst worst;
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
                    const double error = std::abs(double(picture.radiance[i]) - double(truth[v][i])) /
                                         std::max(double(truth[v][i]), 1e-9);
                    errors.push_back(error);
                    if (error > worst.error) {
                        worst = Worst{error, v, degrees_from_sun(views[v].frame, int(i / 3)),
                                      double(truth[v][i]) / double(unshaded[v][i])};
                    }
                }
            }
            bar(++done, pictures);
        }
        char line[256];
        const double middle = at_rank(errors, 0.5);
        const double most = at_rank(errors, 0.95);
        std::snprintf(line, sizeof line, "| %s | %.3g | %.3g | %.3g | %s %g, %.1f, %.2g | %.3g |\n",
                      method.name.c_str(), 100 * middle, 100 * most, 100 * worst.error,
                      suns[worst.view].camera.c_str(), suns[worst.view].elevation, worst.degrees_from_sun,
                      100 * worst.left, milliseconds);
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
         << "Where the worst pixel lies: the view, degrees from the sun, and how many % of its light without "
            "shadows the\npixel keeps.\n\n"
         << "| method | median, % | 95 % within, % | worst, % | where | ms |\n|---|---|---|---|---|---|\n"
         << rows.str();
    support::print_or_write(page, text.str());
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
