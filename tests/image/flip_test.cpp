#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "flip.hpp"

#include <doctest/doctest.h>

#include <cstddef>

namespace {

constexpr int width = 24;
constexpr int height = 20;

std::vector<float> even(float red, float green, float blue) {
    std::vector<float> picture;
    for (int i = 0; i < width * height; ++i) {
        picture.insert(picture.end(), {red, green, blue});
    }
    return picture;
}

float largest(const std::vector<float>& a, const std::vector<float>& b) {
    float most = 0;
    for (const float d : image::flip_difference(a, b, width, height)) {
        most = std::max(most, d);
    }
    return most;
}

}  // namespace

TEST_CASE("a picture does not differ from itself") {
    std::vector<float> picture = even(0.2f, 0.5f, 0.1f);
    picture[300] = 1;
    CHECK(largest(picture, picture) == 0);  // exact: every difference is of equal numbers
}

TEST_CASE("green and blue are as different as colours get; black and white almost") {
    // By hand: 100^0.7 = 25.12 is the distance of black and white, 41.28 of green and blue, and so
    // 0.95 + 0.05 (25.12 - 16.51) / (41.28 - 16.51) = 0.967.
    CHECK(largest(even(0, 1, 0), even(0, 0, 1)) == doctest::Approx(1).epsilon(1e-6));  // float of the result
    CHECK(largest(even(0, 0, 0), even(1, 1, 1)) == doctest::Approx(0.967).epsilon(1e-3));  // digits by hand
}

TEST_CASE("a line is seen better than the same light spread out") {
    const std::vector<float> grey = even(0.2f, 0.2f, 0.2f);
    std::vector<float> line = grey;
    for (int x = 0; x < width; ++x) {
        for (int c = 0; c < 3; ++c) {
            line[std::size_t(3 * (width * (height / 2) + x) + c)] += 0.2f;
        }
    }
    const float spread = 0.2f + 0.2f / float(height);
    CHECK(largest(grey, line) > 2 * largest(grey, even(spread, spread, spread)));
}

TEST_CASE("who stands further off sees less of a single pixel") {
    const std::vector<float> grey = even(0.2f, 0.2f, 0.2f);
    std::vector<float> speck = grey;
    speck[std::size_t(3 * (width * (height / 2) + width / 2))] = 1;
    const auto sum = [&](double pixels_per_degree) {
        double all = 0;
        for (const float d : image::flip_difference(grey, speck, width, height, pixels_per_degree)) {
            all = std::max(all, double(d));
        }
        return all;
    };
    CHECK(sum(30) > sum(60));
    CHECK(sum(60) > sum(120));
}
