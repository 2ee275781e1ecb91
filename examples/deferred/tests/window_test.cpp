// What a window of deferred shows: the picture that the same options write to a file, and the panel over it.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "support/image.hpp"

namespace {

const std::filesystem::path folder = PICTURE_FOLDER;
constexpr int panel_end = 252;  // the panel covers half of 480 pixels, 4 from the left

int at(const support::Picture& picture, int x, int y, int channel) {
    return picture.pixels[std::size_t(3 * (y * picture.width + x) + channel)];
}

}  // namespace

TEST_CASE("beside the panel the window shows what the file shows: upright, and encoded once") {
    const support::Picture window = support::read_picture_png(folder / "window.png");
    const support::Picture file = support::read_picture_png(folder / "ground_sun+20.png");
    REQUIRE(window.width == file.width);
    REQUIRE(window.height == file.height);
    int worst = 0;
    for (int y = 0; y < window.height; ++y) {
        for (int x = panel_end; x < window.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(at(window, x, y, c) - at(file, x, y, c)));
            }
        }
    }
    CHECK(worst == 0);  // exact: one renderer, one driver, bytes copied
}

TEST_CASE("the sky is above and blue, the ground below and not") {
    const support::Picture window = support::read_picture_png(folder / "window.png");
    for (int x = panel_end; x < window.width; x += 16) {
        CHECK(at(window, x, 4, 2) > at(window, x, 4, 0) + 30);
        CHECK(at(window, x, window.height - 5, 2) < at(window, x, window.height - 5, 1));
    }
}

TEST_CASE("the panel is there: dark, with bright letters") {
    const support::Picture window = support::read_picture_png(folder / "window.png");
    int dark = 0;
    int white = 0;
    for (int y = 10; y < window.height - 10; ++y) {
        for (int x = 10; x < 230; ++x) {
            const int r = at(window, x, y, 0);
            const int g = at(window, x, y, 1);
            const int b = at(window, x, y, 2);
            dark += int(r < 60 && g < 90);
            white += int(r > 240 && g > 240 && b > 240);
        }
    }
    const int pixels = 220 * (window.height - 20);
    CHECK(dark > pixels / 2);
    CHECK(white > pixels / 100);
    CHECK(white < pixels / 4);
}

TEST_CASE("a window takes any size and comes back from one pixel") {
    const support::Picture resized = support::read_picture_png(folder / "resized.png");
    CHECK(resized.width == 64);
    CHECK(resized.height == 36);
    const support::Picture one = support::read_picture_png(folder / "one.png");
    CHECK(one.width == 1);
    CHECK(one.height == 1);
}
