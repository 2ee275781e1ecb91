#include "sequence.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include "cpu_frame.hpp"
#include "path.hpp"
#include "picture_files.hpp"
#include "renderer.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"
#include "support/image.hpp"
#include "support/progress.hpp"
#include "tables.hpp"
#include "terrain.hpp"
#include "view.hpp"

namespace deferred {
namespace {

std::vector<Moment> moments_of(const Options& options) {
    const Moment start{options.cameras.front(), options.sun_elevations.front(), options.sun_azimuth};
    switch (*options.sequence) {
        case SequenceKind::flight:
            return flight(options.frames, start, double(options.world.atmosphere.ground_radius));
        case SequenceKind::day:
            return day(options.frames, start.camera, options.latitude);
        case SequenceKind::turntable:
            break;
    }
    return turntable(options.frames, start);
}

/// The exposure of each picture: fixed, or three quarters of the way in logarithms from the last one's to
/// what suits this one, so that it follows without flicker.
class Adaptation {
  public:
    explicit Adaptation(const std::optional<double>& fixed) : fixed_(fixed) {}

    float operator()(float suitable) {
        if (fixed_) {
            return float(*fixed_);
        }
        const float seen = std::min(suitable, darkest);
        last_ = last_ > 0 ? seen * std::pow(last_ / seen, 0.25f) : seen;
        return last_;
    }

  private:
    /// Ten thousand times that of a day: what is darker than late twilight stays dark.
    static constexpr float darkest = 1e5f;

    std::optional<double> fixed_;
    float last_ = 0;
};

}  // namespace

void draw_sequence(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const Terrain terrain(read_height_map(options.height_map, options.step_east, options.step_north));

    // Every view before the first picture: a camera below the ground stops the run while nothing is written.
    std::vector<View> views;
    for (const Moment& moment : moments_of(options)) {
        const Picturing picturing{options.width,   options.height, moment.sun_elevation, moment.sun_azimuth,
                                  options.marched, options.steps,  options.sky_steps,    options.settings};
        views.push_back(
            make_view(moment.camera, picturing, double(options.world.atmosphere.ground_radius), terrain));
    }
    support::make_writable_directory(options.output);

    const support::GlContext context;
    // The tables hang on the air alone, so they serve every picture.
    const AirTables tables = bake_tables(options.tables, options.world);
    Renderer renderer(options.world, tables, terrain, options.settings, options.width, options.height);
    Adaptation adapted(options.exposure);
    support::ProgressBar progress(sequence_names()[std::size_t(*options.sequence)]);
    for (std::size_t i = 0; i < views.size(); ++i) {
        progress(i, views.size());
        renderer.draw(views[i], options.settings);
        const GpuPicture picture = renderer.read();
        const std::vector<bool> disc = disc_pixels(views[i].frame, picture.surfaces);
        const float exposure = adapted(automatic_exposure(picture.radiance, disc));
        char name[32];
        std::snprintf(name, sizeof name, "frame_%04zu.png", i);
        support::write_png(
            std::filesystem::path(options.output) / name,
            upright(renderer.display(options.settings, exposure), options.width, options.height));
    }
    progress(views.size(), views.size());
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    std::printf("%zu frames of %d x %d in %.1f s, in %s\n", views.size(), options.width, options.height,
                duration.count(), std::filesystem::absolute(options.output).lexically_normal().c_str());
}

}  // namespace deferred
