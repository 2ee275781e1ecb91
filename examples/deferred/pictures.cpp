#include "pictures.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "cpu_frame.hpp"
#include "picture_files.hpp"
#include "renderer.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"
#include "support/image.hpp"
#include "tables.hpp"
#include "terrain.hpp"
#include "view.hpp"

namespace deferred {
namespace {

std::string picture_name(const Camera& camera, double sun_elevation) {
    char sun[32];
    std::snprintf(sun, sizeof sun, "%+.4g", sun_elevation);
    return camera.name + "_sun" + sun;
}

}  // namespace

void draw_pictures(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const Terrain terrain(read_height_map(options.height_map, options.step_east, options.step_north));
    const double ground_radius = double(options.world.atmosphere.ground_radius);

    // Every view before the first picture: a camera below the ground stops the run while nothing is written.
    struct Shot {
        std::string name;
        View view;
    };
    std::vector<Shot> shots;
    for (const Camera& camera : options.cameras) {
        for (const double elevation : options.sun_elevations) {
            const Picturing picturing{options.width,   options.height, elevation,         options.sun_azimuth,
                                      options.marched, options.steps,  options.sky_steps, options.settings};
            shots.push_back(
                {picture_name(camera, elevation), make_view(camera, picturing, ground_radius, terrain)});
        }
    }
    support::make_writable_directory(options.output);

    const support::GlContext context;
    const AirTables tables = bake_tables(options.tables, options.world);
    Renderer renderer(options.world, tables, terrain, options.settings, options.width, options.height);
    std::cout << "OpenGL " << context.version() << " on " << context.renderer() << "; reversed depth "
              << (has_clip_control() ? "by glClipControl"
                                     : "emulated in the projection, without glClipControl")
              << "\n";

    const std::filesystem::path folder = options.output;
    double worst = 0;
    std::string worst_name;
    for (const Shot& shot : shots) {
        const Frame& frame = shot.view.frame;
        renderer.draw(shot.view, options.settings);
        const GpuPicture picture = renderer.read();
        const std::vector<bool> disc = disc_pixels(frame, picture.surfaces);
        const float exposure =
            options.exposure ? float(*options.exposure) : automatic_exposure(picture.radiance, disc);
        support::write_exr(folder / (shot.name + ".exr"), layers(picture, frame));
        support::write_png(folder / (shot.name + ".png"),
                           upright(renderer.display(options.settings, exposure), frame.width, frame.height));
        std::printf("%s: camera at %.6g m, exposure %.4g, light and air in %.0f ms on the GPU\n",
                    shot.name.c_str(), shot.view.altitude, double(exposure), picture.milliseconds);
        if (options.times) {
            for (const PassTime& pass : renderer.timers().read(true)) {
                std::printf("%s: %-12s %9.3f ms on the GPU\n", shot.name.c_str(), pass.name.c_str(),
                            pass.milliseconds);
            }
        }

        if (options.difference) {
            const auto cpu_start = std::chrono::steady_clock::now();
            const std::vector<float> cpu = light_on_cpu(options.world, tables, frame, picture.surfaces);
            const std::chrono::duration<double, std::milli> cpu_time =
                std::chrono::steady_clock::now() - cpu_start;
            const Comparison comparison = compare(picture.radiance, cpu, frame.width, frame.height, disc);
            support::write_png(folder / (shot.name + ".difference.png"),
                               upright(comparison.picture, frame.width, frame.height));
            std::printf("%s: %s; %.0f ms on the CPU\n", shot.name.c_str(), describe(comparison).c_str(),
                        cpu_time.count());
            if (worst_name.empty() || comparison.largest > worst) {
                worst = comparison.largest;
                worst_name = shot.name;
            }
        }
        std::fflush(stdout);
    }
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    std::printf("%zu pictures of %d x %d in %.1f s, in %s\n", shots.size(), options.width, options.height,
                duration.count(), std::filesystem::absolute(folder).lexically_normal().c_str());
    if (options.difference) {
        std::printf("worst of all: %.2e in %s\n", worst, worst_name.c_str());
        if (options.tolerance && !(worst <= *options.tolerance)) {
            char text[160];
            std::snprintf(text, sizeof text,
                          "the largest relative difference %.3g, in %s, is above --tolerance %g; see its "
                          "difference picture",
                          worst, worst_name.c_str(), *options.tolerance);
            throw support::Error(text);
        }
    }
}

}  // namespace deferred
