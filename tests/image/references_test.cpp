// Compares fixed views with the pictures in references/, or makes those anew.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <airlight/color.hpp>

#include "flip.hpp"
#include "half.hpp"
#include "picture_files.hpp"
#include "studio.hpp"
#include "support/command_line.hpp"
#include "support/files.hpp"
#include "support/gl_test.hpp"
#include "support/image.hpp"

namespace {

constexpr int width = 160;
constexpr int height = 90;

// A wrong pixel at an edge is a speck, a wrong formula an area. So single pixels may differ, areas not. One
// driver draws the same halves again; two differ by 1e-5 in smooth places and in the pixels at edges.
constexpr int block = 10;                 // pixels each way
constexpr double tolerated_mean = 5e-4;   // 7 of the 14400 pixels are all wrong
constexpr double tolerated_block = 0.02;  // 2 of its 100 pixels are all wrong
constexpr double tolerated_flip = 2e-3;   // a fiftieth of what FLIP says of an exposure 10 % off: 0.1

struct View {
    std::string name;
    std::string world;
    deferred::Camera camera;
    double sun_elevation;
    double sun_azimuth;
    deferred::Shafts shafts;
    float exposure;
};

deferred::Camera looking(deferred::Camera camera, double heading, double pitch, double field_of_view) {
    camera.heading = heading;
    camera.pitch = pitch;
    camera.field_of_view = field_of_view;
    return camera;
}

deferred::Camera raised(deferred::Camera camera, double altitude) {
    camera.altitude = altitude;
    camera.above_landscape = false;
    return camera;
}

std::vector<View> views() {
    using deferred::Shafts;
    using image::camera_called;
    const deferred::Camera ground = camera_called("ground");
    const deferred::Camera valley = camera_called("valley");
    const deferred::Camera airliner = camera_called("10km");
    const deferred::Camera orbit = camera_called("orbit");
    // Above the night side, the sun behind the planet.
    const deferred::Camera far = looking(raised(orbit, 3e6), 250, -50, 40);
    return {
        {"noon", "earth", ground, 60, 180, Shafts::none, 8},
        {"sunset", "earth", ground, 1, 262, Shafts::none, 15},
        {"twilight", "earth", ground, -5, 250, Shafts::none, 600},
        {"valley", "earth", valley, 9, 235, Shafts::march, 30},
        {"10km", "earth", airliner, 20, 200, Shafts::none, 10},
        {"orbit", "earth", orbit, 30, 160, Shafts::none, 8},
        {"limb", "earth", looking(orbit, 250, -19.5, 6), -22, 245, Shafts::none, 20},
        {"night", "earth", far, -52, 250, Shafts::none, 100},
        {"mars", "mars", ground, 12, 240, Shafts::none, 12},
        {"haze", "haze", valley, 25, 250, Shafts::none, 10},
    };
}

/// Exposed light before the display's curve, rounded as in the files.
std::vector<float> exposed_light(const image::LinearPicture& picture, float exposure) {
    std::vector<float> light;
    for (const float radiance : picture.radiance) {
        // The sun's disc is more than a half holds.
        light.push_back(float(airlight_test::as_half(double(std::min(radiance * exposure, 6e4f)))));
    }
    return light;
}

support::ExrImage file_of(const View& view, const std::vector<float>& light) {
    support::ExrImage image{width, height, {{"R", {}}, {"G", {}}, {"B", {}}}, {}, true};
    for (std::size_t i = 0; i < light.size(); ++i) {
        image.channels[i % 3].pixels.push_back(light[i]);
    }
    char exposure[32];
    std::snprintf(exposure, sizeof exposure, "%g", double(view.exposure));
    image.attributes = {{"units", "exposure times radiance per solar irradiance [1/sr], linear"},
                        {"exposure", exposure}};
    return image;
}

std::vector<float> light_of(const support::ExrImage& image) {
    std::vector<float> light(3 * std::size_t(image.width) * std::size_t(image.height));
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t i = 0; i < light.size(); ++i) {
        light[i] = support::find_channel(image, names[i % 3])->pixels[i / 3];
    }
    return light;
}

std::vector<float> displayed(std::vector<float> light) {
    for (float& x : light) {
        x = 1 - std::exp(-x);
    }
    return light;
}

support::Picture encoded(const std::vector<float>& linear) {
    support::Picture picture{width, height, {}};
    for (std::size_t i = 0; i < linear.size(); i += 3) {
        const auto srgb =
            airlight::srgb_from_linear(airlight::vec3<float>(linear[i], linear[i + 1], linear[i + 2]));
        for (int c = 0; c < 3; ++c) {
            picture.pixels.push_back(std::uint8_t(std::lround(255 * std::clamp(srgb[c], 0.0f, 1.0f))));
        }
    }
    return picture;
}

/// The worst channel's difference relative to the mean of what is around, in 9 x 9 pixels, for each pixel.
std::vector<double> relative_errors(const std::vector<float>& reference, const std::vector<float>& test) {
    double whole = 0;
    for (const float x : reference) {
        whole += double(std::min(x, 10.0f)) / double(reference.size());
    }
    std::vector<double> errors;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double around = 0;
            int count = 0;
            for (int v = std::max(y - 4, 0); v <= std::min(y + 4, height - 1); ++v) {
                for (int u = std::max(x - 4, 0); u <= std::min(x + 4, width - 1); ++u) {
                    for (int c = 0; c < 3; ++c) {
                        around += double(std::min(reference[std::size_t(3 * (v * width + u) + c)], 10.0f));
                        ++count;
                    }
                }
            }
            double error = 0;
            for (int c = 0; c < 3; ++c) {
                const std::size_t i = std::size_t(3 * (y * width + x) + c);
                // What is brighter than 10 is white on every display: the disc, as bright as it may be.
                error = std::max(error, std::abs(double(std::min(reference[i], 10.0f)) -
                                                 double(std::min(test[i], 10.0f))));
            }
            // Black space has no light to compare with; there a thousandth of the picture's mean is none.
            errors.push_back(error / std::max(around / count, 1e-3 * whole));
        }
    }
    return errors;
}

template <typename Number>
double mean(const std::vector<Number>& numbers) {
    double sum = 0;
    for (const Number x : numbers) {
        sum += double(x);
    }
    return sum / double(numbers.size());
}

struct WorstBlock {
    double error;
    int x;
    int y;
};

WorstBlock worst_block(const std::vector<double>& errors) {
    WorstBlock worst{-1, 0, 0};
    for (int y = 0; y < height; y += block) {
        for (int x = 0; x < width; x += block) {
            double sum = 0;
            for (int v = y; v < y + block; ++v) {
                for (int u = x; u < x + block; ++u) {
                    sum += errors[std::size_t(v * width + u)];
                }
            }
            if (!(sum / (block * block) <= worst.error)) {  // so that no number is worst of all
                worst = {sum / (block * block), x, y};
            }
        }
    }
    return worst;
}

/// Black for equal, white for all wrong, in between on a logarithmic scale from 1e-4.
support::Picture drawn(const std::vector<float>& errors) {
    support::Picture picture{width, height, {}};
    for (const float error : errors) {
        const double share = std::clamp(1 + std::log10(std::max(double(error), 1e-9)) / 4, 0.0, 1.0);
        picture.pixels.insert(picture.pixels.end(), 3, std::uint8_t(std::lround(255 * share)));
    }
    return picture;
}

bool compare(const View& view, const std::vector<float>& light, const std::filesystem::path& references,
             const std::filesystem::path& output) {
    const support::ExrImage file = support::read_exr(references / (view.name + ".exr"));
    if (file.width != width || file.height != height) {
        std::printf("%-10s the reference is %d x %d, not %d x %d\n", view.name.c_str(), file.width,
                    file.height, width, height);
        return false;
    }
    const std::vector<float> reference = light_of(file);
    const std::vector<double> errors = relative_errors(reference, light);
    const std::vector<float> flip =
        image::flip_difference(displayed(reference), displayed(light), width, height);
    const WorstBlock worst = worst_block(errors);
    const double seen = mean(flip);
    const bool good =
        mean(errors) <= tolerated_mean && worst.error <= tolerated_block && seen <= tolerated_flip;
    std::printf(
        "%-10s light %.1e in the mean (%.0e), %.1e in the worst block, at %d,%d (%.1e); FLIP %.1e (%.0e)%s\n",
        view.name.c_str(), mean(errors), tolerated_mean, worst.error, worst.x, worst.y, tolerated_block, seen,
        tolerated_flip, good ? "" : "  FAILED");
    if (!good) {
        support::write_exr(output / (view.name + ".exr"), file_of(view, light));
        support::write_png(output / (view.name + ".png"), encoded(displayed(light)));
        support::write_png(output / (view.name + ".reference.png"), encoded(displayed(reference)));
        support::write_png(output / (view.name + ".light.png"),
                           drawn(std::vector<float>(errors.begin(), errors.end())));
        support::write_png(output / (view.name + ".flip.png"), drawn(flip));
        std::printf("           see %s: the picture, its reference and where the two differ\n",
                    (output / (view.name + ".*")).c_str());
    }
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Compares views of the renderer in examples/deferred with the pictures in a folder.");
    std::string references;
    std::string output = ".";
    bool update = false;
    support::add_value(app, "--references", "FOLDER", references, "the pictures to compare with")->required();
    support::add_value(app, "--output", "FOLDER", output,
                       "where PNGs go: of pictures that differ, or of all new ones");
    support::add_switch(app, "--update", update, "write the pictures to compare with instead");
    return support::guarded_main(app, argc, argv, [&] {
        const auto context = support::open_context();
        if (context == nullptr) {
            return support::skipped;
        }
        support::make_writable_directory(output);
        if (update) {
            support::make_writable_directory(references);
        }
        bool good = true;
        std::unique_ptr<image::Studio> studio;
        deferred::Shafts made_with = deferred::Shafts::none;
        for (const View& view : views()) {
            deferred::Settings settings;
            settings.shafts = view.shafts;
            settings.shadow_size = 1024;
            // A renderer has the passes of the settings that it was made with.
            if (studio == nullptr || studio->world_name() != view.world || made_with != view.shafts) {
                made_with = view.shafts;
                studio = std::make_unique<image::Studio>(view.world, settings, width, height);
            }
            const deferred::Moment moment{view.camera, view.sun_elevation, view.sun_azimuth};
            const std::vector<float> light = exposed_light(studio->draw(moment, settings), view.exposure);
            if (update) {
                support::write_exr(std::filesystem::path(references) / (view.name + ".exr"),
                                   file_of(view, light));
                support::write_png(std::filesystem::path(output) / (view.name + ".png"),
                                   encoded(displayed(light)));
            } else {
                good = compare(view, light, references, output) && good;
            }
        }
        if (update) {
            std::printf("%zu pictures in %s\n", views().size(), references.c_str());
        }
        return good ? 0 : 1;
    });
}
