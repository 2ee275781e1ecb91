// What the small pictures of the tests of the scene's switches must show.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "layers.hpp"

namespace {

Layers picture(const std::string& test, const std::string& name) {
    return Layers(std::filesystem::path(OUTPUT_FOLDER) / test / name);
}

}  // namespace

TEST_CASE("towers stand upright in the valley, before the hills") {
    const Layers view = picture("deferred_objects", "shafts_sun+6");
    int walls = 0;
    for (std::size_t i = 0; i < view.channel("depth.Z").size(); ++i) {
        const float depth = view.channel("depth.Z")[i];
        if (depth > 2000 && depth < 3500 && std::abs(view.channel("normal.Z")[i]) < 0.01f) {
            ++walls;
        }
    }
    CHECK(walls > 50);
}

TEST_CASE("from orbit a station lies in front of the air and a ball in front of space") {
    const Layers view = picture("deferred_objects", "orbit_sun+6");
    const std::vector<float>& depth = view.channel("depth.Z");
    int before_air = 0;
    int before_space = 0;
    for (int x = 0; x < view.image.width; ++x) {
        for (int y = 0; y + 1 < view.image.height; ++y) {
            const std::size_t i = std::size_t(y * view.image.width + x);
            if (depth[i] > 2000 && depth[i] < 4000) {
                const bool high = y < view.horizon();
                ++(high ? before_space : before_air);
            }
        }
    }
    CHECK(before_air > 20);
    CHECK(before_space > 5);
}

TEST_CASE("stars shine at night; by day they are there and the air outshines them") {
    const Layers night = picture("deferred_stars", "ground_sun-25");
    const Layers day = picture("deferred_stars", "ground_sun+20");
    int stars = 0;
    for (int y = 0; y < night.horizon() - 1; ++y) {
        for (int x = 3; x < night.image.width - 3; ++x) {
            const std::size_t i = std::size_t(y * night.image.width + x);
            if (night.channel("albedo.G")[i] < 0.01f) {
                continue;
            }
            ++stars;
            CHECK(day.channel("albedo.G")[i] == night.channel("albedo.G")[i]);
            const std::vector<float>& dark = night.channel("radiance.G");
            CHECK(dark[i] > 1e-10f);
            const std::vector<float>& bright = day.channel("radiance.G");
            const float around = 0.5f * (bright[i - 3] + bright[i + 3]);
            CHECK(std::abs(bright[i] - around) < 0.02f * around);  // the sky itself bends by as much
        }
    }
    CHECK(stars > 20);
}

TEST_CASE("the full moon lights the ground at night, a few hundred thousand times less than the sun by day") {
    const Layers moonlit = picture("deferred_moon", "ground_sun-25");
    const Layers moonless = picture("deferred_stars", "ground_sun-25");
    const Layers day = picture("deferred_moon", "ground_sun+20");
    const int height = moonlit.image.height;
    const float light = moonlit.mean("radiance.G", height - 8, height);
    CHECK(light > 100 * moonless.mean("radiance.G", height - 8, height));
    CHECK(light > 1e-7f * day.mean("radiance.G", height - 8, height));
    CHECK(light < 1e-5f * day.mean("radiance.G", height - 8, height));
}

TEST_CASE("the full moon is as bright as dust of albedo 0.12 in sunlight, less what the air takes") {
    const Layers view = picture("deferred_moon", "ground_sun-25");
    const std::vector<float>& light = view.channel("radiance.G");
    const float disc = *std::max_element(light.begin(), light.end());
    // Albedo 0.12 when full, over pi, through the air.
    CHECK(disc > 0.005f);
    CHECK(disc < 0.12f / 3.14f);
}

TEST_CASE("by day clouds are brighter than the ground below them, which they shade") {
    const Layers view = picture("deferred_clouds", "10km_sun+20");
    const std::vector<float>& light = view.channel("radiance.G");
    double cloud = 0;
    double ground = 0;
    int cloud_pixels = 0;
    int ground_pixels = 0;
    float darkest = 1;
    for (std::size_t i = std::size_t((view.horizon() + 4) * view.image.width); i < light.size(); ++i) {
        if (view.channel("clouds.Y")[i] < 0.1f) {
            cloud += double(light[i]);
            ++cloud_pixels;
        } else if (view.channel("clouds.Y")[i] > 0.95f) {
            ground += double(light[i]);
            ++ground_pixels;
        }
        darkest = std::min(darkest, view.channel("sunlit.Y")[i]);
    }
    REQUIRE(cloud_pixels > 100);
    REQUIRE(ground_pixels > 100);
    CHECK(cloud / cloud_pixels > 1.5 * ground / ground_pixels);
    CHECK(darkest < 0.7f);
}

TEST_CASE("within a cloud nothing else is seen") {
    const Layers view = picture("deferred_inside_clouds", "10km_sun+10");
    float most = 0;
    for (const float through : view.channel("clouds.Y")) {
        most = std::max(most, through);
    }
    CHECK(most < 0.5f);
}
