#include "habitat/pictures.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>

#include "comparison.hpp"
#include "habitat/renderer.hpp"
#include "passes/pass.hpp"
#include "picture_files.hpp"
#include "reference/habitat.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"
#include "support/image.hpp"
#include "support/rows.hpp"
#include "view.hpp"

namespace deferred::habitat {
namespace {

constexpr double degree = airlight::pi<double> / 180;

/// Throws support::Error when the camera is in the land.
Frame make_frame(const Camera& camera, const Land& land, const Options& options) {
    const double around = camera.around * degree;
    const double height = camera.height + land.height(camera.along, around);
    if (height > 2 * land.radius() - land.height(camera.along, around + airlight::pi<double>)) {
        throw support::Error("camera " + camera.name + " at " + std::to_string(height) +
                             " m is in the land on the other side; give a smaller --height");
    }
    const glm::dvec3 up(0, -std::cos(around), -std::sin(around));
    const glm::dvec3 spinward(0, -std::sin(around), std::cos(around));
    const auto compass = [&](double elevation) {
        const glm::dvec3 level = std::cos(camera.heading * degree) * glm::dvec3(1, 0, 0) +
                                 std::sin(camera.heading * degree) * spinward;
        return std::cos(elevation * degree) * level + std::sin(elevation * degree) * up;
    };
    Frame frame{};
    aim(frame, compass(camera.pitch), compass(camera.pitch + 90), camera.field_of_view, options.width,
        options.height);
    frame.eye_position = vec3(glm::dvec3(camera.along, 0, 0) - (land.radius() - height) * up);
    return frame;
}

/// A pixel of the G-buffer.
struct Pixel {
    vec3 direction;
    float distance;  ///< [m]
    Surface surface;
};

Pixel pixel_of(const Frame& frame, const GBuffer& surfaces, int x, int y) {
    const std::size_t i = std::size_t(y) * std::size_t(frame.width) + std::size_t(x);
    const vec3 ray =
        frame.ray_corner + (float(x) + 0.5f) * frame.ray_across + (float(y) + 0.5f) * frame.ray_up;
    const float ray_length = std::sqrt(airlight::dot_product(ray, ray));
    const float depth = surfaces.depth[i];
    const vec3 direction = ray / ray_length;
    const float distance = depth > 0 ? frame.near_distance / depth * ray_length : 0;
    const float* const albedo = &surfaces.albedo[4 * i];
    const float* const normal = &surfaces.normal[4 * i];
    return Pixel{direction, distance,
                 Surface{frame.eye_position + distance * direction, vec3(albedo[0], albedo[1], albedo[2]),
                         vec3(normal[0], normal[1], normal[2]), albedo[3]}};
}

/// A picture of three numbers a pixel.
template <typename Light>
std::vector<float> each_pixel(const Frame& frame, const GBuffer& surfaces, const support::Rows& rows,
                              const Light& light) {
    std::vector<float> radiance(3 * std::size_t(frame.width) * std::size_t(frame.height));
    rows(frame.height, [&](int y) {
        for (int x = 0; x < frame.width; ++x) {
            const int pixel = y * frame.width + x;
            const vec3 value = light(pixel_of(frame, surfaces, x, y), pixel);
            for (int c = 0; c < 3; ++c) {
                radiance[3 * std::size_t(pixel) + std::size_t(c)] = value[c];
            }
        }
    });
    return radiance;
}

std::vector<float> light_on_cpu(const World& world, const Tables& tables, const Frame& frame,
                                const GBuffer& surfaces) {
    return each_pixel(frame, surfaces, support::Rows{}, [&](const Pixel& pixel, int) {
        const vec3 passed = airlight::habitat_transmittance<float, airlight::DefaultScene>(
            world.air, frame.eye_position, pixel.surface.position);
        return light_of_surface(world, tables, pixel.surface) * passed +
               light_of_air(world, tables, frame.eye_position, pixel.direction, pixel.distance);
    });
}

reference::Vector as_double(const vec3& v) {
    return reference::Vector(v);
}

/// What a path tracer makes of the same surfaces: all orders of light where the world has bounces, else light
/// that is scattered once.
std::vector<float> traced_light(const World& world, const Frame& frame, const GBuffer& surfaces, int walks,
                                const std::string& name) {
    const auto& a = world.air;
    const auto& l = world.lights;
    const reference::Habitat habitat{
        {double(a.radius), double(a.density_rise), as_double(a.rayleigh_scattering),
         as_double(a.mie_scattering), as_double(a.mie_absorption), double(a.mie_g)},
        {double(l.half_length), double(l.begin), double(l.end), double(l.width), as_double(l.radiance),
         double(l.fine), double(l.fine_share)},
        as_double(world.wall_albedo)};
    const int orders = world.bounces > 0 ? reference::every_order : 1;
    return each_pixel(frame, surfaces, support::Rows(name + ", traced"), [&](const Pixel& pixel, int i) {
        const Surface& surface = pixel.surface;
        return vec3(reference::habitat_pixel(
            habitat, as_double(frame.eye_position), glm::normalize(as_double(pixel.direction)),
            double(pixel.distance), glm::normalize(as_double(surface.normal)),
            as_double(surface.albedo * (1 - surface.strip)), as_double(l.radiance * surface.strip), orders,
            std::uint64_t(walks), std::uint64_t(i)));
    });
}

/// How far a picture is from another, where neither shows a strip.
struct Distance {
    double median;    ///< of the pixels' differences, all colours together, relative
    double high;      ///< 95 % of them are smaller
    double of_means;  ///< of the pictures' means
};

Distance distance_of(const std::vector<float>& picture, const std::vector<float>& truth,
                     const std::vector<bool>& strips) {
    std::vector<double> differences;
    double sum = 0;
    double sum_of_truth = 0;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        if (!strips[i]) {
            double here = 0;
            double there = 0;
            for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
                here += double(picture[c]);
                there += double(truth[c]);
            }
            sum += here;
            sum_of_truth += there;
            differences.push_back(there > 0 ? std::abs(here / there - 1) : 0);
        }
    }
    if (differences.empty()) {
        return Distance{};
    }
    std::sort(differences.begin(), differences.end());
    const auto rank = [&](double share) {
        return differences[std::size_t(share * double(differences.size() - 1))];
    };
    return Distance{rank(0.5), rank(0.95), sum_of_truth > 0 ? sum / sum_of_truth - 1 : 0};
}

/// Pixels that show a strip, which no exposure follows.
std::vector<bool> strip_pixels(const GBuffer& surfaces) {
    std::vector<bool> strips;
    for (std::size_t i = 3; i < surfaces.albedo.size(); i += 4) {
        strips.push_back(surfaces.albedo[i] > 0);
    }
    return strips;
}

/// Of all that is no strip.
vec3 mean_albedo(const GBuffer& surfaces) {
    glm::dvec3 sum(0);
    double count = 0;
    for (std::size_t i = 0; i < surfaces.albedo.size(); i += 4) {
        const float* const albedo = &surfaces.albedo[i];
        if (albedo[3] <= 0) {
            sum += glm::dvec3(double(albedo[0]), double(albedo[1]), double(albedo[2]));
            count += 1;
        }
    }
    return vec3(sum / std::max(count, 1.0));
}

support::ExrImage habitat_layers(const GpuPicture& picture, const Frame& frame) {
    support::ExrImage image = layers(picture, frame);
    for (support::ExrChannel& channel : image.channels) {
        channel.name = channel.name == "roughness.Y" ? "strip.Y" : channel.name;
    }
    image.attributes = {
        {"radianceUnits", "per radiance of the strips; linear, not exposed; before bloom"},
        {"depthUnits", "metres along the view axis"},
        {"normalUnits", "unit vectors; x along the axis, y from it to the first strip"},
        {"albedoUnits", "1, reflected share of the light"},
        {"stripUnits", "1, share of the pixel that a strip of light fills"},
    };
    return image;
}

}  // namespace

void draw_pictures(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    if (!options.shaders.empty()) {
        set_shader_folder(options.shaders);
    }
    const World& world = options.world;
    const Land land(read_height_map(options.height_map, options.step_east, options.step_north),
                    double(world.air.radius), world.lights, options.plain);
    // Every view before the first picture: a camera in the land stops the run while nothing is written.
    std::vector<Frame> frames;
    for (const Camera& camera : options.cameras) {
        frames.push_back(make_frame(camera, land, options));
    }
    support::make_writable_directory(options.output);

    const support::GlContext context;
    const Tables tables = bake_tables(world);
    HabitatRenderer renderer(world, tables, land, options.plain, options.width, options.height);
    std::cout << "OpenGL " << context.version() << " on " << context.renderer() << "\n";

    const std::filesystem::path folder = options.output;
    double worst = 0;
    std::string worst_name;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Frame& frame = frames[i];
        const std::string& name = options.cameras[i].name;
        renderer.draw(frame);
        const GpuPicture picture = renderer.read();
        const std::vector<bool> strips = strip_pixels(picture.surfaces);
        const float exposure = options.exposure.value_or(automatic_exposure(picture.radiance, strips));
        support::write_exr(folder / (name + ".exr"), habitat_layers(picture, frame));
        support::write_png(folder / (name + ".png"),
                           upright(renderer.display(options.settings, exposure), frame.width, frame.height));
        const vec3 albedo = mean_albedo(picture.surfaces);
        std::printf(
            "%s: camera %.6g m above the land, which has a mean albedo of %.3f %.3f %.3f here; exposure "
            "%.4g, light and air in %.0f ms on the GPU\n",
            name.c_str(), options.cameras[i].height, double(albedo.x), double(albedo.y), double(albedo.z),
            double(exposure), picture.milliseconds);
        if (options.times) {
            for (const PassTime& pass : renderer.timers().read(true)) {
                std::printf("%s: %-12s %9.3f ms on the GPU\n", name.c_str(), pass.name.c_str(),
                            pass.milliseconds);
            }
        }
        if (options.difference) {
            const Comparison comparison =
                compare(picture.radiance, light_on_cpu(world, tables, frame, picture.surfaces), frame.width,
                        frame.height, strips);
            support::write_png(folder / (name + ".difference.png"),
                               upright(comparison.picture, frame.width, frame.height));
            std::printf("%s: %s\n", name.c_str(), describe(comparison).c_str());
            if (worst_name.empty() || comparison.largest > worst) {
                worst = comparison.largest;
                worst_name = name;
            }
        }
        if (options.truth > 0) {
            GpuPicture traced = picture;
            traced.radiance = traced_light(world, frame, picture.surfaces, options.truth, name);
            support::write_exr(folder / (name + ".truth.exr"), habitat_layers(traced, frame));
            renderer.replace(traced.radiance);
            support::write_png(
                folder / (name + ".truth.png"),
                upright(renderer.display(options.settings, exposure), frame.width, frame.height));
            const Distance off = distance_of(picture.radiance, traced.radiance, strips);
            std::printf(
                "%s: off the path tracer by %.2g %% in the median, 95 %% of the pixels by less than "
                "%.2g %%, its %d walks' own noise included; the mean by %+.2g %%\n",
                name.c_str(), 100 * off.median, 100 * off.high, options.truth, 100 * off.of_means);
        }
        std::fflush(stdout);
    }
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    std::printf("%zu pictures of %d x %d in %.1f s, in %s\n", frames.size(), options.width, options.height,
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

}  // namespace deferred::habitat
