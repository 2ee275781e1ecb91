// What each pass of a frame costs on this machine, beside copying the buffers that the air's pass reads and
// writes. Writes a page in Markdown.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "by_name.hpp"
#include "renderer.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"
#include "support/machine.hpp"
#include "support/progress.hpp"

namespace deferred {
namespace {

/// Milliseconds by pass, in the order of the passes, the fastest of several frames.
class Times {
  public:
    void add(const std::vector<PassTime>& frame) {
        for (const PassTime& pass : frame) {
            const auto [place, fresh] = fastest_.emplace(pass.name, pass.milliseconds);
            if (fresh) {
                names_.push_back(pass.name);
            }
            place->second = std::min(place->second, pass.milliseconds);
        }
    }

    const std::vector<std::string>& names() const {
        return names_;
    }

    double of(const std::string& name) const {
        const auto found = fastest_.find(name);
        return found == fastest_.end() ? 0 : found->second;
    }

  private:
    std::vector<std::string> names_;
    std::map<std::string, double> fastest_;
};

double time_of_copy(int width, int height, int runs) {
    const support::Program program = read_screen_program("copy.frag");
    const support::Texture depth = support::create_texture(GL_DEPTH_COMPONENT32F, width, height);
    const support::Texture behind = support::create_texture(GL_RGBA32F, width, height);
    const support::Texture radiance[] = {support::create_texture(GL_RGBA32F, width, height),
                                         support::create_texture(GL_RGBA32F, width, height)};
    // In turn: of several copies into one target Mesa's llvmpipe draws the last alone.
    const support::Framebuffer targets[] = {make_target({radiance[0]}), make_target({radiance[1]})};
    const support::Uniforms uniforms(program);
    uniforms.set("depth_texture", 0);
    uniforms.set("behind_texture", 1);
    bind_texture(0, depth);
    bind_texture(1, behind);
    // By the clock, many at once: a software driver's queries end before a pass as short as this one does.
    constexpr int copies = 20;
    double fastest = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        glFinish();
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < copies; ++i) {
            draw_screen(targets[i % 2], width, height);
        }
        glFinish();
        const std::chrono::duration<double, std::milli> duration = std::chrono::steady_clock::now() - start;
        fastest = std::min(fastest, duration.count() / copies);
    }
    return fastest;
}

void measure(int width, int height, int runs, const std::string& page) {
    const World world = worlds().front();
    const Terrain terrain(read_height_map(DEFERRED_HEIGHT_MAP, 74, 93));
    const support::GlContext context;
    const std::vector<std::string> cameras = {"ground", "valley", "10km", "orbit"};
    constexpr double sun_elevation = 20;

    support::ProgressBar bar("frames");
    const std::size_t frames = 2 * cameras.size() * std::size_t(runs);
    std::size_t done = 0;
    std::vector<std::vector<Times>> columns;
    for (const TableKind kind : {TableKind::none, TableKind::diffuse}) {
        const AirTables tables = bake_tables(kind, world);
        Settings settings;
        settings.shafts = Shafts::march;
        settings.half_shafts = true;
        settings.flare = true;
        Renderer renderer(world, tables, terrain, settings, width, height);
        std::vector<Times>& views = columns.emplace_back();
        for (const std::string& name : cameras) {
            const Picturing picturing{width, height, sun_elevation, 250, false, 40, 12, settings};
            const View view = make_view(by_name(named_cameras(), name, "camera"), picturing,
                                        double(world.atmosphere.ground_radius), terrain);
            Times& times = views.emplace_back();
            for (int run = 0; run < runs; ++run) {
                renderer.draw(view, settings);
                renderer.display(settings, 10);
                times.add(renderer.timers().read(true));
                bar(++done, frames);
            }
        }
    }
    const double copy = time_of_copy(width, height, runs);

    std::ostringstream text;
    char line[256];
    text << "# What a frame costs\n\n"
         << "GPU time of the passes of `deferred` at " << width << " x " << height << " with the sun at "
         << sun_elevation << " degrees, in milliseconds, the\nfastest of " << runs
         << " frames, by timer queries, on " << context.renderer() << ", " << support::processor_name()
         << ".\nShafts by march at half the resolution. Written by `measure_frame --write docs/frame.md`.\n";
    for (std::size_t t = 0; t < columns.size(); ++t) {
        text << "\n## " << (t == 0 ? "Single scattering" : "With the table of light from all sides")
             << "\n\n| pass |";
        std::string rule = "|---|";
        for (const std::string& name : cameras) {
            text << " " << name << " |";
            rule += "---|";
        }
        text << "\n" << rule << "\n";
        for (const std::string& pass : columns[t].front().names()) {
            text << "| " << pass << " |";
            for (const Times& times : columns[t]) {
                std::snprintf(line, sizeof line, " %.3g |", times.of(pass));
                text << line;
            }
            text << "\n";
        }
        text << "| air / copy |";
        for (const Times& times : columns[t]) {
            std::snprintf(line, sizeof line, " %.2g |", times.of("air") / copy);
            text << line;
        }
        text << "\n";
    }
    std::snprintf(
        line, sizeof line,
        "\nCopying what the air's pass reads (depth, light behind) to what it writes takes %.3g ms.\n", copy);
    text << line;
    support::print_or_write(page, text.str());
}

}  // namespace
}  // namespace deferred

int main(int count, char** arguments) {
    CLI::App app("Measures what each pass of a frame costs on this machine.");
    app.set_help_flag("--help", "Print this and stop");
    int width = 1920;
    int height = 1080;
    int runs = 3;
    std::string page;
    app.add_option("--width", width, "Pixels; 1920 if not given")->check(CLI::Range(16, 8192));
    app.add_option("--height", height, "Pixels; 1080 if not given")->check(CLI::Range(16, 8192));
    app.add_option("--runs", runs, "Frames of each view; 3 if not given")->check(CLI::Range(1, 1000));
    app.add_option("--write", page, "The Markdown page to write; standard output if not given");
    CLI11_PARSE(app, count, arguments);
    try {
        deferred::measure(width, height, runs, page);
        return 0;
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << "measure_frame: " << error.what() << "\n";
        return 1;
    }
}
