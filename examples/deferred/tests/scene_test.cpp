// What the small pictures of the tests of the scene's switches must show.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

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
