// Draws a real landscape on a planet in its air: surfaces, then light and air, then exposure and sRGB. The
// light and the air are computed by the GPU with the generated GLSL and by the CPU with the headers.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "cpu_frame.hpp"
#include "options.hpp"
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

/// OpenGL's lowest row first becomes the files' top row first. `stride` values a pixel, `channel` of them.
std::vector<float> plane(const std::vector<float>& pixels, int width, int height, int stride, int channel) {
    std::vector<float> values(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t from = std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x);
            values[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
                pixels[from * std::size_t(stride) + std::size_t(channel)];
        }
    }
    return values;
}

support::Picture upright(const std::vector<std::uint8_t>& pixels, int width, int height) {
    support::Picture picture{width, height, {}};
    picture.pixels.reserve(pixels.size());
    const std::ptrdiff_t row = 3 * std::ptrdiff_t(width);
    for (int y = height - 1; y >= 0; --y) {
        picture.pixels.insert(picture.pixels.end(), pixels.begin() + y * row, pixels.begin() + (y + 1) * row);
    }
    return picture;
}

support::ExrImage layers(const GpuPicture& picture, const Frame& frame) {
    support::ExrImage image{frame.width, frame.height, {}, {}};
    const auto add = [&](const std::string& name, const std::vector<float>& pixels, int stride, int channel) {
        image.channels.push_back({name, plane(pixels, frame.width, frame.height, stride, channel)});
    };
    add("radiance.R", picture.radiance, 3, 0);
    add("radiance.G", picture.radiance, 3, 1);
    add("radiance.B", picture.radiance, 3, 2);
    add("albedo.R", picture.surfaces.albedo, 4, 0);
    add("albedo.G", picture.surfaces.albedo, 4, 1);
    add("albedo.B", picture.surfaces.albedo, 4, 2);
    add("roughness.Y", picture.surfaces.albedo, 4, 3);
    add("normal.X", picture.surfaces.normal, 4, 0);
    add("normal.Y", picture.surfaces.normal, 4, 1);
    add("normal.Z", picture.surfaces.normal, 4, 2);
    add("sunlit.Y", picture.surfaces.shares, 4, 0);
    add("skylit.Y", picture.surfaces.shares, 4, 1);
    add("depth.Z", picture.surfaces.depth, 1, 0);
    // Reversed depth back to a distance; division by 0 gives the infinity it stands for.
    for (float& depth : image.channels.back().pixels) {
        depth = frame.near_distance / depth;
    }
    image.attributes = {
        {"radianceUnits",
         "1/sr: radiance per solar irradiance above the air; linear, not exposed; before bloom and flare"},
        {"depthUnits", "metres along the view axis; infinite where there is no surface"},
        {"normalUnits", "unit vectors; x east, y north, z up at the landscape's centre; 0 without a surface"},
        {"albedoUnits", "1, reflected share of the light"},
        {"sunlitUnits", "1, share of the sun that nothing hides"},
        {"skylitUnits", "1, share of the sky that nothing hides"},
    };
    return image;
}

/// Brings the middle of what is lit to the middle of the display's scale.
float automatic_exposure(const std::vector<float>& radiance, const std::vector<bool>& disc) {
    std::vector<float> lit;
    for (std::size_t i = 0; i < disc.size(); ++i) {
        if (!disc[i]) {
            lit.push_back(
                airlight::luminance(vec3(radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2])));
        }
    }
    std::sort(lit.begin(), lit.end());
    // Space and night are no part of it: a hundredth of what is bright is dark.
    const float bright = lit.empty() ? 0 : lit[std::size_t(0.98 * double(lit.size() - 1))];
    const auto first = std::upper_bound(lit.begin(), lit.end(), 0.01f * bright);
    if (first == lit.end()) {
        return 1;
    }
    const float middle = *(first + (lit.end() - first) / 2);
    return std::clamp(0.25f / middle, 1e-6f, 1e12f);
}

std::string picture_name(const Camera& camera, double sun_elevation) {
    char sun[32];
    std::snprintf(sun, sizeof sun, "%+.4g", sun_elevation);
    return camera.name + "_sun" + sun;
}

void run(const Options& options) {
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

}  // namespace
}  // namespace deferred

int main(int count, char** arguments) {
    try {
        const std::optional<deferred::Options> options = deferred::parse_options(count, arguments);
        if (options) {
            deferred::run(*options);
        }
        return 0;
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << "deferred: " << error.what() << "\n";
        return 1;
    }
}
