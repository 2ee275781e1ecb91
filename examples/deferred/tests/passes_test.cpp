// Single passes on made-up pictures.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "passes/bloom.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "blocks.hpp"
#include "frame.hpp"
#include "passes/flare.hpp"
#include "passes/occlusion.hpp"
#include "passes/tone.hpp"
#include "support/gl_context.hpp"

namespace {

using deferred::BloomPass;
using deferred::FlarePass;
using deferred::OcclusionPass;
using glm::dvec3;

constexpr float infinity = std::numeric_limits<float>::infinity();

void require_context() {
    static const support::GlContext context;
}

support::Texture upload(GLenum internal_format, GLenum format, int width, int height,
                        const std::vector<float>& pixels) {
    support::Texture texture = support::create_texture(internal_format, width, height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, format, GL_FLOAT, pixels.data());
    return texture;
}

/// Light of three colours at one pixel, in the ratio 1 : 2 : 4, on black.
std::vector<float> spot(int width, int height, int x, int y, float radiance) {
    std::vector<float> pixels(4 * std::size_t(width) * std::size_t(height));
    for (std::size_t c = 0; c < 3; ++c) {
        pixels[4 * std::size_t(y * width + x) + c] = radiance * float(1 << c);
    }
    return pixels;
}

double sum_of(const std::vector<float>& pixels, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < pixels.size(); i += 4) {
        sum += double(pixels[i]);
    }
    return sum;
}

double largest(const std::vector<float>& pixels) {
    double most = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            // Neither is NaN the largest nor is it passed over.
            most = pixels[i + c] >= 0 ? std::max(most, double(pixels[i + c])) : HUGE_VAL;
        }
    }
    return most;
}

/// The glow of a picture at half its size, 4 values per pixel.
std::vector<float> glow_of(int width, int height, const std::vector<float>& pixels) {
    require_context();
    BloomPass bloom(width, height);
    bloom.reduce(upload(GL_RGBA32F, GL_RGBA, width, height, pixels));
    bloom.spread();
    const BloomPass::Level& half = bloom.levels().front();
    std::vector<float> glow =
        deferred::read_texture(bloom.glow(), GL_RGBA, 4 * std::size_t(half.width) * std::size_t(half.height));
    support::check_gl("drawing bloom");
    return glow;
}

std::vector<float> flare_of(int width, int height, const std::vector<float>& pixels) {
    require_context();
    BloomPass bloom(width, height);
    FlarePass flare(bloom);
    bloom.reduce(upload(GL_RGBA32F, GL_RGBA, width, height, pixels));
    flare.draw(bloom);
    const BloomPass::Level& half = bloom.levels().front();
    std::vector<float> radiance = deferred::read_texture(
        flare.radiance(), GL_RGBA, 4 * std::size_t(half.width) * std::size_t(half.height));
    support::check_gl("drawing a flare");
    return radiance;
}

/// The bytes of a picture with bloom and flare.
std::vector<std::uint8_t> toned(int width, int height, const std::vector<float>& pixels) {
    require_context();
    BloomPass bloom(width, height);
    FlarePass flare(bloom);
    deferred::TonePass tone(width, height);
    deferred::Settings settings;
    settings.flare = true;
    const support::Texture radiance = upload(GL_RGBA32F, GL_RGBA, width, height, pixels);
    bloom.reduce(radiance);
    bloom.spread();
    flare.draw(bloom);
    tone.draw(radiance, 0, bloom, flare, settings, 1);
    return tone.read();
}

/// What a ray from the eye meets, `direction` of length 1 along the view axis y.
struct Hit {
    double axis_distance;  ///< 0 where there is nothing
    dvec3 normal;
};

using Scene = std::function<Hit(const dvec3& direction)>;

/// The share of the sky that every pixel of a scene sees, from an eye that looks along y with z up.
std::vector<float> sky_shares(int width, int height, double half_height, const Scene& scene) {
    require_context();
    deferred::Frame frame{};
    const double pixel = 2 * half_height / height;
    frame.width = width;
    frame.height = height;
    frame.ray_across = deferred::vec3(float(pixel), 0, 0);
    frame.ray_up = deferred::vec3(0, 0, float(pixel));
    frame.ray_corner = deferred::vec3(float(-0.5 * width * pixel), 1, float(-half_height));
    frame.near_distance = 0.1f;
    const deferred::BlockBuffer<deferred::Frame> block(deferred::Block::frame);
    block.upload(frame);

    std::vector<float> depth;
    std::vector<float> normal;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Hit hit =
                scene(dvec3((x + 0.5 - 0.5 * width) * pixel, 1, (y + 0.5 - 0.5 * height) * pixel));
            depth.push_back(hit.axis_distance > 0 ? float(0.1 / hit.axis_distance) : 0);
            for (const double component : {hit.normal.x, hit.normal.y, hit.normal.z, 0.0}) {
                normal.push_back(float(component));
            }
        }
    }
    OcclusionPass occlusion(width, height);
    occlusion.draw(upload(GL_R32F, GL_RED, width, height, depth),
                   upload(GL_RGBA16F, GL_RGBA, width, height, normal));
    std::vector<float> shares =
        deferred::read_texture(occlusion.share(), GL_RED, std::size_t(width) * std::size_t(height));
    support::check_gl("drawing occlusion");
    return shares;
}

/// A level plane below the eye, or above where `height` is negative.
Hit plane(double height, const dvec3& direction) {
    const double distance = -height / direction.z;
    return distance > 0 ? Hit{distance, dvec3(0, 0, height > 0 ? 1 : -1)} : Hit{};
}

float least(const std::vector<float>& values) {
    float smallest = infinity;
    for (const float value : values) {
        smallest = value >= smallest ? smallest : value;
    }
    return smallest;
}

float most(const std::vector<float>& values) {
    float highest = -infinity;
    for (const float value : values) {
        highest = value <= highest ? highest : value;
    }
    return highest;
}

}  // namespace

TEST_SUITE_BEGIN("bloom");

TEST_CASE("no light is gained or lost, to the picture's very edge") {
    // Sizes whose levels are all even: light that leaves an edge comes back. 1e-5 is of rounding 5 levels.
    for (const auto& [x, y] : {std::pair{64, 32}, std::pair{37, 11}, std::pair{0, 0}, std::pair{127, 5}}) {
        const std::vector<float> before = spot(128, 64, x, y, 1000);
        const std::vector<float> glow = glow_of(128, 64, before);
        for (std::size_t c = 0; c < 3; ++c) {
            CHECK(4 * sum_of(glow, c) == doctest::Approx(sum_of(before, c)).epsilon(1e-5));
        }
    }
}

TEST_CASE("at an odd size a light in the middle loses little at the edges") {
    const std::vector<float> before = spot(125, 71, 62, 35, 1000);
    const double after = 4 * sum_of(glow_of(125, 71, before), 0);
    CHECK(after == doctest::Approx(sum_of(before, 0)).epsilon(0.02));
}

TEST_CASE("an even picture stays as it is, at any size") {
    for (const auto& size :
         {std::pair{1, 1}, std::pair{3, 2}, std::pair{7, 33}, std::pair{8192, 16}, std::pair{100, 50}}) {
        const int width = size.first;
        const int height = size.second;
        CAPTURE(width);
        const std::vector<float> pixels(4 * std::size_t(width) * std::size_t(height), 0.25f);
        const std::vector<float> glow = glow_of(width, height, pixels);
        CHECK(least(glow) > 0.25f * (1 - 1e-6f));
        CHECK(most(glow) < 1 + 1e-6f);  // the fourth channel
        CHECK(largest(glow) < 0.25 * (1 + 1e-6));
    }
}

TEST_CASE("the glow of a light in the middle is the same to all four sides") {
    std::vector<float> pixels = spot(64, 64, 31, 31, 1000);
    for (const auto& [x, y] : {std::pair{32, 31}, std::pair{31, 32}, std::pair{32, 32}}) {
        pixels[4 * std::size_t(y * 64 + x)] = 1000;
    }
    const std::vector<float> glow = glow_of(64, 64, pixels);
    const auto at = [&](int x, int y) { return double(glow[4 * std::size_t(y * 32 + x)]); };
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            CHECK(at(x, y) == doctest::Approx(at(31 - x, y)).epsilon(1e-5));
            CHECK(at(x, y) == doctest::Approx(at(y, x)).epsilon(1e-5));
        }
    }
}

TEST_CASE("the glow has no edge: it falls at every step away from the light, and is round") {
    std::vector<float> pixels = spot(256, 256, 127, 127, 1000);
    const std::vector<float> glow = glow_of(256, 256, pixels);
    const auto at = [&](int x, int y) { return double(glow[4 * std::size_t(y * 128 + x)]); };
    for (int x = 64; x < 126; ++x) {
        CHECK(at(x + 1, 63) < at(x, 63));
    }
    // 30 to the side is as far as 21.2 along both. Measured: 0.90, as 21 is less than 21.2.
    CHECK(at(63 + 30, 63) == doctest::Approx(at(63 + 21, 63 + 21)).epsilon(0.15));
}

TEST_CASE("a small light that moves by whole pixels flickers little") {
    double dimmest = HUGE_VAL;
    double brightest = 0;
    for (const int x : {40, 41, 42, 43, 45, 47}) {
        const double peak = largest(glow_of(64, 32, spot(64, 32, x, 16, 1000)));
        dimmest = std::min(dimmest, peak);
        brightest = std::max(brightest, peak);
    }
    CHECK(brightest < 1.001 * dimmest);  // measured: 1.0003
}

TEST_CASE("what is brighter than the sun can be does not glow more, and nothing becomes NaN") {
    for (const float radiance : {1e30f, infinity, std::numeric_limits<float>::quiet_NaN()}) {
        for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 2}, std::pair{64, 36}}) {
            const std::vector<float> glow =
                glow_of(width, height, spot(width, height, width / 2, height / 2, radiance));
            CHECK(largest(glow) <= 1.5e5 * (1 + 1e-6));
            CHECK(largest(flare_of(width, height, spot(width, height, width / 2, height / 2, radiance))) <=
                  1.5e5);
        }
    }
    const std::vector<float> glow = glow_of(64, 36, spot(64, 36, 32, 18, 1e30f));
    CHECK(4 * sum_of(glow, 0) == doctest::Approx(1.5e5).epsilon(0.02));
}

TEST_CASE("far brighter pixels leave the display white there, and dark elsewhere") {
    const std::vector<std::uint8_t> bytes = toned(64, 36, spot(64, 36, 32, 18, 1e30f));
    CHECK(bytes[3 * (18 * 64 + 32)] == 255);
    const std::vector<std::uint8_t> small = toned(1, 1, {0, 0, 0, 0});
    CHECK(small == std::vector<std::uint8_t>{0, 0, 0});
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("flare");

TEST_CASE("without a bright pixel there is no flare") {
    std::vector<float> pixels(4 * 64 * 36, 9.9f);
    CHECK(largest(flare_of(64, 36, pixels)) == 0);  // exact: below the threshold
}

TEST_CASE("the sun has ghosts on the other side of the picture") {
    std::vector<float> pixels = spot(64, 64, 15, 15, 15000);
    const std::vector<float> flare = flare_of(64, 64, pixels);
    double opposite = 0;
    for (int y = 16; y < 32; ++y) {
        for (int x = 16; x < 32; ++x) {
            opposite += double(flare[4 * std::size_t(y * 32 + x)]);
        }
    }
    CHECK(opposite > 0);
    CHECK(opposite < 1e-2 * 15000);  // a lens mirrors less than a hundredth of what it lets through
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("occlusion");

TEST_CASE("open level ground sees its whole sky, from any height") {
    for (const double height : {1.0, 2.0, 100.0, 1e4, 1e6}) {
        CAPTURE(height);
        const std::vector<float> shares =
            sky_shares(96, 54, 0.4, [&](const dvec3& direction) { return plane(height, direction); });
        CHECK(least(shares) > 0.98f);
        CHECK(most(shares) <= 1);
    }
}

TEST_CASE("the planet's sphere sees its whole sky, seen from orbit") {
    const double radius = 6.371e6;
    for (const double altitude : {4e5, 1e8}) {
        CAPTURE(altitude);
        const dvec3 centre = (radius + altitude) * glm::normalize(dvec3(0, 1, altitude < 1e6 ? -1.2 : -0.01));
        const Scene sphere = [&](const dvec3& direction) {
            const double length = glm::length(direction);
            const double along = glm::dot(centre, direction) / length;
            const double half_chord = radius * radius - (glm::dot(centre, centre) - along * along);
            if (half_chord < 0 || along < 0) {
                return Hit{};
            }
            const double distance = along - std::sqrt(half_chord);
            return Hit{distance / length, (direction / length * distance - centre) / radius};
        };
        CHECK(least(sky_shares(96, 54, altitude < 1e6 ? 0.4 : 0.07, sphere)) > 0.98f);
    }
}

TEST_CASE("a corner sees less, the less the nearer to its edge, at every scale") {
    // A floor 2 m below and a wall 8 m ahead, and the same larger.
    for (const double scale : {1.0, 100.0, 1e5}) {
        CAPTURE(scale);
        const std::vector<float> shares = sky_shares(64, 64, 0.4, [&](const dvec3& direction) {
            const Hit floor = plane(2 * scale, direction);
            return floor.axis_distance > 0 && floor.axis_distance < 8 * scale
                       ? floor
                       : Hit{8 * scale, dvec3(0, -1, 0)};
        });
        const auto column = [&](int row) { return double(shares[std::size_t(row * 64 + 32)]); };
        // The edge is 2/8 below the axis: row 12.
        CHECK(column(12) < 0.85);
        CHECK(column(12) > 0.45);  // an endless wall hides half
        CHECK(column(11) < 0.9);
        CHECK(column(13) < column(15));
        CHECK(column(2) > 0.95);
        CHECK(column(30) > 0.98);
    }
}

TEST_CASE("what stands far in front of a surface casts no halo on it") {
    const std::vector<float> shares = sky_shares(64, 64, 0.4, [&](const dvec3& direction) {
        return Hit{std::abs(direction.x) < 0.1 ? 50.0 : 100.0, dvec3(0, -1, 0)};
    });
    CHECK(least(shares) > 0.98f);
}

TEST_CASE("no size is too small") {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 2}, std::pair{16, 1}}) {
        const std::vector<float> shares = sky_shares(
            width, height, 0.4, [&](const dvec3& direction) { return plane(2, direction - dvec3(0, 0, 1)); });
        CHECK(least(shares) > 0.9f);
        CHECK(most(shares) <= 1);
    }
}

TEST_SUITE_END();
