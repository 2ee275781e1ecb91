// How eye and sun move in a window, and what its settings are as text.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "settings_text.hpp"
#include "steering.hpp"
#include "support/files.hpp"

namespace deferred {
namespace {

constexpr double earth_radius = 6360e3;

/// A plain 100 m high.
Terrain plain() {
    return Terrain(HeightMap{3, 3, 1000, 1000, std::vector<float>(9, 100)});
}

Camera camera_at(double altitude, double heading, double pitch) {
    return Camera{"test", 0, 0, altitude, false, heading, pitch, 40};
}

}  // namespace

TEST_CASE("flying goes where the camera looks, as far each second as it is above the ground") {
    const Terrain terrain = plain();
    const Camera east = flown(camera_at(1100, 90, 0), Steering{1, 0, 0, 1}, 0.1, earth_radius, terrain);
    CHECK(east.east == doctest::Approx(100).epsilon(1e-3));  // the ground's circle is shorter by 1100/6360e3
    CHECK(east.north == doctest::Approx(0).epsilon(1e-6));
    const Camera up = flown(camera_at(1100, 0, 0), Steering{0, 0, 1, 5}, 0.1, earth_radius, terrain);
    CHECK(up.altitude == doctest::Approx(1600));
    const Camera right = flown(camera_at(1100, 0, 0), Steering{0, 1, 0, 1}, 0.1, earth_radius, terrain);
    CHECK(right.east == doctest::Approx(100).epsilon(1e-3));
}

TEST_CASE("flying never ends below the ground, nor out of what the command line takes") {
    const Terrain terrain = plain();
    Camera camera = camera_at(150, 0, -80);
    for (int i = 0; i < 1000; ++i) {
        camera = flown(camera, Steering{1, 0, -1, 5}, 0.25, earth_radius, terrain);
        REQUIRE(camera.altitude >= terrain.height(camera.east, camera.north) + 1);
    }
    camera = camera_at(1e6, 45, 10);
    for (int i = 0; i < 1000; ++i) {
        camera = flown(camera, Steering{1, 0, 0, 5}, 0.25, earth_radius, terrain);
        REQUIRE(std::hypot(camera.east, camera.north) <= 3000e3);
        REQUIRE(camera.altitude <= 1e9);
        REQUIRE(std::isfinite(camera.heading));
    }
}

TEST_CASE("a way around is a way back: out and home along a great circle") {
    const Terrain terrain = plain();
    const Camera start = camera_at(400e3, 60, 0);
    const Camera out = flown(start, Steering{1, 0, 0, 1}, 0.25, earth_radius, terrain);
    // The tangent that led there leads home when it is turned by the angle between the two verticals.
    const double arc = std::hypot(out.east, out.north) / earth_radius;
    const Camera back = turned(out, 180, 2 * -arc * 180 / airlight::pi<double>);
    const Camera home = flown(back, Steering{1, 0, 0, 1}, 100e3 / out.altitude, earth_radius, terrain);
    CHECK(std::hypot(home.east, home.north) < 2000);
    CHECK(std::abs(home.heading - 240) < 0.1);
}

TEST_CASE("turning stops at the zenith and the nadir, and goes around the compass") {
    CHECK(turned(camera_at(0, 350, 80), 20, 30).heading == doctest::Approx(10));
    CHECK(turned(camera_at(0, 350, 80), 20, 30).pitch == 90);
    CHECK(turned(camera_at(0, 10, -80), -20, -30).heading == doctest::Approx(350));
    CHECK(turned(camera_at(0, 10, -80), -20, -30).pitch == -90);
}

TEST_CASE("the sun goes west over the south, around in a day, and is not moved at the pole of its sky") {
    const SkyPlace noon{53.6, 180};  // at an equinox, 36.4 degrees north
    const SkyPlace later = hours_later(noon, 3, 36.4);
    CHECK(later.elevation < noon.elevation);
    CHECK(later.azimuth > 180);
    CHECK(later.azimuth < 270);
    const SkyPlace sunset = hours_later(noon, 6, 36.4);
    CHECK(sunset.elevation == doctest::Approx(0).epsilon(1e-9));
    CHECK(sunset.azimuth == doctest::Approx(270));
    const SkyPlace day = hours_later(noon, 24, 36.4);
    CHECK(day.elevation == doctest::Approx(noon.elevation));
    CHECK(day.azimuth == doctest::Approx(noon.azimuth));
    CHECK(hours_later(SkyPlace{36.4, 0}, 5, 36.4).elevation == doctest::Approx(36.4));
}

TEST_CASE("settings as text have every number of the air, to its last bit") {
    for (World world : worlds()) {
        CAPTURE(world.name);
        world.nodes = 12;
        world.atmosphere.rayleigh_scale_height = 8123.4567f;
        const std::string cpp = as_cpp(world);
        const std::string glsl = as_glsl(world);
        CHECK(cpp.find("nodes = 12;") != std::string::npos);
        CHECK(glsl.find("#define AIRLIGHT_NODES 12\n") != std::string::npos);
        CHECK((cpp.find("ozone_lorentzian") != std::string::npos) == world.lorentzian_ozone);
        CHECK((glsl.find("OZONE_LORENTZIAN") != std::string::npos) == world.lorentzian_ozone);
        // For the tests that compile them.
        support::write_file(
            std::filesystem::path(TEXT_FOLDER) / (world.name + ".cpp"),
            "#include <airlight/airlight.hpp>\n" + cpp +
                "static_assert(Scene::nodes == 12);\nfloat top() { return air.top_altitude; }\n");
        support::write_file(
            std::filesystem::path(TEXT_FOLDER) / (world.name + ".frag"),
            "#version 430 core\n#extension GL_GOOGLE_include_directive : require\n" + glsl +
                "out vec4 color;\nvoid main() {\n    color = vec4(air.ground_albedo, 1.0);\n}\n");
        for (const std::string& text : {cpp, glsl}) {
            const std::size_t line = text.rfind('\n', text.find("rayleigh_scale_height"));
            CHECK(std::strtof(text.c_str() + line + 1, nullptr) == world.atmosphere.rayleigh_scale_height);
        }
    }
}

}  // namespace deferred
