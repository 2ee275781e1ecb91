// Shadows on the ground and in the air, as the renderer draws them.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "by_name.hpp"
#include "passes/epipolar.hpp"
#include "renderer.hpp"
#include "support/gl_context.hpp"

namespace {

using deferred::Settings;
using deferred::Shafts;

constexpr int width = 96;
constexpr int height = 54;

const deferred::World& earth() {
    return deferred::worlds().front();
}

const deferred::Terrain& landscape() {
    static const deferred::Terrain terrain(deferred::read_height_map(DEFERRED_HEIGHT_MAP, 74, 93));
    return terrain;
}

deferred::View view_of(const std::string& name, double sun_elevation, double sun_azimuth,
                       const Settings& settings) {
    const deferred::Picturing picturing{width, height, sun_elevation, sun_azimuth, false, 40, 12, settings};
    return deferred::make_view(deferred::by_name(deferred::named_cameras(), name, "camera"), picturing,
                               double(earth().atmosphere.ground_radius), landscape());
}

struct Drawn {
    deferred::GpuPicture picture;
    std::vector<std::uint8_t> bytes;
};

Drawn drawn(const std::string& camera, double sun_elevation, double sun_azimuth, const Settings& settings) {
    static const deferred::AirTables tables = deferred::bake_tables(deferred::TableKind::none, earth());
    deferred::Renderer renderer(earth(), tables, landscape(), settings, width, height);
    renderer.draw(view_of(camera, sun_elevation, sun_azimuth, settings), settings);
    return Drawn{renderer.read(), renderer.display(settings, 20)};
}

Settings with(Shafts shafts) {
    Settings settings;
    settings.shafts = shafts;
    settings.shadow_size = 1024;
    return settings;
}

/// The relative difference that `share` of the pixels' channels stay within, the sun's disc left out.
double difference(const std::vector<float>& a, const std::vector<float>& b, double share) {
    REQUIRE(a.size() == b.size());
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(std::isfinite(a[i]));
        REQUIRE(a[i] >= 0);
        if (b[i] < 10) {
            differences.push_back(std::abs(double(a[i]) - double(b[i])) / std::max(double(b[i]), 1e-9));
        }
    }
    std::sort(differences.begin(), differences.end());
    return differences[std::size_t(share * double(differences.size() - 1))];
}

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) {
        sum += double(value);
    }
    return sum / double(values.size());
}

}  // namespace

TEST_CASE("shafts are those of 800 even steps, by looks along each ray and by slices") {
    const support::GlContext context;
    struct Sky {
        const char* camera;
        double elevation;
        double azimuth;
    };
    // The sun in the picture, beside it, behind the camera with its opposite point in the picture, and
    // overhead.
    for (const Sky& sky : {Sky{"valley", 12, 250}, Sky{"valley", 8, 200}, Sky{"valley", 4, 70},
                           Sky{"10km", 5, 250}, Sky{"valley", 89, 250}}) {
        CAPTURE(sky.camera);
        CAPTURE(sky.elevation);
        CAPTURE(sky.azimuth);
        const auto radiance = [&sky](const Settings& settings) {
            return drawn(sky.camera, sky.elevation, sky.azimuth, settings).picture.radiance;
        };
        const std::vector<float> truth = radiance(with(Shafts::reference));
        const std::vector<float> smooth = radiance(with(Shafts::none));
        CHECK(mean(truth) <=
              1.001 * mean(smooth));  // shadows only take; the thousandth is the march's own error
        // Modelling, docs/shafts.md: 1 % at 320 x 180. At this size a pixel is three times as wide and
        // neighbours differ by more.
        constexpr double near = 0.04;
        CHECK(difference(radiance(with(Shafts::march)), truth, 0.95) < near);
        CHECK(difference(radiance(with(Shafts::epipolar)), truth, 0.95) < near);
        if (sky.elevation < 10 && sky.azimuth != 250) {
            CHECK(difference(smooth, truth, 0.95) > near);  // without shafts the picture is another one
        }
    }
}

TEST_CASE("every ray of the picture has a place among the slices, the sun wherever it is") {
    for (const double azimuth : {250.0, 200.0, 70.0, 340.0}) {
        for (const double elevation : {12.0, 60.0, 90.0, -4.0}) {
            CAPTURE(azimuth);
            CAPTURE(elevation);
            const deferred::Frame frame = view_of("valley", elevation, azimuth, Settings{}).frame;
            const deferred::EpipolarBlock block = deferred::epipolar_block(frame, 5e4, 512, 256, 1024);
            CHECK(block.slice_range > 0);
            CHECK(block.slice_range <= 6.2832f);
            for (int y = 0; y < height; y += 3) {
                for (int x = 0; x < width; x += 3) {
                    const glm::vec3 ray =
                        glm::normalize(frame.ray_corner + (float(x) + 0.5f) * frame.ray_across +
                                       (float(y) + 0.5f) * frame.ray_up);
                    const float angle = std::acos(glm::clamp(glm::dot(ray, frame.to_sun), -1.0f, 1.0f));
                    CHECK(angle >= block.first_angle - 1e-3f);  // acos has lost half of its digits near 0
                    CHECK(angle <= block.first_angle + block.angle_range + 1e-3f);
                    const float around =
                        std::atan2(glm::dot(ray, block.slice_y), glm::dot(ray, block.slice_x));
                    const float turn = 6.28318531f;
                    float from_first = std::fmod(around - block.first_slice + 2 * turn, turn);
                    from_first -= from_first > turn - 1e-3f ? turn : 0;
                    CHECK(from_first <= block.slice_range + 1e-3f);
                }
            }
        }
    }
}

TEST_CASE("each of the four maps has its colour") {
    const support::GlContext context;
    Settings settings = with(Shafts::none);
    const std::vector<float> cascades = drawn("ground", 20, 250, settings).picture.surfaces.shares;
    std::set<int> seen;
    for (std::size_t i = 2; i < cascades.size(); i += 4) {
        seen.insert(int(cascades[i]));
    }
    CHECK(seen.size() >= 4);  // three maps and more, and the sky, which has none
    const std::vector<std::uint8_t> plain = drawn("ground", 20, 250, settings).bytes;
    settings.cascade_colors = true;
    CHECK(drawn("ground", 20, 250, settings).bytes != plain);
    settings.shadows = false;
    const std::vector<std::uint8_t> unshaded = drawn("ground", 20, 250, settings).bytes;
    settings.cascade_colors = false;
    CHECK(drawn("ground", 20, 250, settings).bytes == unshaded);  // without maps there is nothing to colour
}

TEST_CASE("without air the sky is black and shadows are") {
    const support::GlContext context;
    Settings settings = with(Shafts::none);
    settings.air = false;
    const deferred::GpuPicture picture = drawn("ground", 20, 250, settings).picture;
    int shaded = 0;
    for (std::size_t i = 0; i < picture.surfaces.depth.size(); ++i) {
        const float radiance = picture.radiance[3 * i];
        if (!(picture.surfaces.depth[i] > 0)) {
            CHECK((radiance == 0 || radiance > 10));  // or the sun's disc
        } else if (picture.surfaces.shares[4 * i] == 0) {
            CHECK(radiance == 0);
            ++shaded;
        }
    }
    CHECK(shaded > 0);
}
