// What the small pictures of the test deferred_frames must show. Rows count from the top.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "layers.hpp"
#include "support/image.hpp"

namespace {

const std::filesystem::path folder = PICTURE_FOLDER;

Layers picture(const std::string& name) {
    return Layers(folder / name);
}

}  // namespace

TEST_CASE("the sky at noon is blue, and darkest overhead") {
    const Layers noon = picture("ground_sun+60");
    const int horizon = noon.horizon();
    CHECK(noon.mean("radiance.B", 0, 4) > 2 * noon.mean("radiance.R", 0, 4));
    CHECK(noon.mean("radiance.R", 0, 4) < noon.mean("radiance.R", horizon - 4, horizon));
}

TEST_CASE("the sky at sunset is red at the horizon and bluer above") {
    for (const char* name : {"ground_sun+1", "ground_sun-4", "10km_sun-4"}) {
        CAPTURE(name);
        const Layers sunset = picture(name);
        const int horizon = sunset.horizon();
        const float low =
            sunset.mean("radiance.R", horizon - 2, horizon) / sunset.mean("radiance.B", horizon - 2, horizon);
        const float high = sunset.mean("radiance.R", 0, 4) / sunset.mean("radiance.B", 0, 4);
        CHECK(low > 2);
        CHECK(low > 3 * high);
    }
}

TEST_CASE("haze makes far ground bluer and brighter than near ground") {
    const Layers view = picture("10km_sun+60");
    const int horizon = view.horizon();
    const int height = view.image.height;
    const float far = view.mean("radiance.B", horizon + 2, horizon + 6);
    const float near = view.mean("radiance.B", height - 4, height);
    CHECK(far > near);
}

TEST_CASE("space above the limb is black, and deeper in it no air shines") {
    const Layers orbit = picture("orbit_sun+60");
    CHECK(orbit.mean("radiance.R", 0, 8) == 0);  // exact: rays that miss the air
    CHECK(orbit.mean("radiance.B", 0, 8) == 0);
    CHECK(orbit.mean("radiance.B", orbit.image.height - 8, orbit.image.height) > 0);
}

TEST_CASE("ground that the planet hides sees no sunlight, but what little the air hands on") {
    const Layers dusk = picture("10km_sun-4");
    const Layers night = picture("10km_sun-19");
    const int height = night.image.height;
    CHECK(night.mean("radiance.R", height - 4, height) < 1e-9f);  // measured: 3e-11, by many scatterings
    // From -4 to -19 degrees twilight fades by more than a hundred thousand.
    CHECK(night.mean("radiance.R", height - 4, height) < 1e-5f * dusk.mean("radiance.R", height - 4, height));
}

TEST_CASE("every pixel has either a surface with a unit normal, or none and infinite depth") {
    for (const char* name : {"ground_sun+20", "valley_sun+20", "10km_sun+20", "orbit_sun+20"}) {
        CAPTURE(name);
        const Layers view = picture(name);
        const std::vector<float>& depth = view.channel("depth.Z");
        int surfaces = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const float x = view.channel("normal.X")[i];
            const float y = view.channel("normal.Y")[i];
            const float z = view.channel("normal.Z")[i];
            const float length = std::sqrt(x * x + y * y + z * z);
            if (std::isinf(depth[i])) {
                CHECK(length == 0);
                CHECK(view.channel("albedo.R")[i] == 0);
            } else {
                CHECK(depth[i] > 0);
                CHECK(std::abs(length - 1) < 1e-3f);  // stored as halves: 3 roundoffs of 2^-11
                CHECK(view.channel("albedo.R")[i] > 0);
                ++surfaces;
            }
        }
        CHECK(surfaces > 0);
        CHECK(surfaces < int(depth.size()));
    }
}

TEST_CASE("below the horizon no pixel misses the ground: the landscape's edge is closed") {
    for (const char* name : {"ground_sun+20", "valley_sun+20", "10km_sun+20", "orbit_sun+20"}) {
        CAPTURE(name);
        const Layers view = picture(name);
        const std::vector<float>& depth = view.channel("depth.Z");
        for (int x = 0; x < view.image.width; ++x) {
            bool below = false;
            for (int y = 0; y < view.image.height; ++y) {
                const bool surface = !std::isinf(depth[std::size_t(y * view.image.width + x)]);
                CHECK((surface || !below));
                below = below || surface;
            }
        }
    }
}

TEST_CASE("the files say their units") {
    const Layers view = picture("ground_sun+20");
    for (const char* name : {"radianceUnits", "depthUnits", "normalUnits", "albedoUnits"}) {
        CHECK(view.image.attributes.count(name) == 1);
    }
}

TEST_CASE("each picture is there for people too, with its difference") {
    for (const char* ending : {".png", ".difference.png"}) {
        const support::Picture shown =
            support::read_picture_png(folder / (std::string("valley_sun+60") + ending));
        CHECK(shown.width == 96);
        CHECK(shown.height == 54);
    }
}
