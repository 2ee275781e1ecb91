// A flight from 1 m to 1e8 m and a day, picture by picture: nothing jumps.

#include "gl_main.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <airlight/color.hpp>

#include "studio.hpp"

namespace {

constexpr int width = 48;
constexpr int height = 27;
constexpr int block = 9;  // pixels each way: single pixels jump when an edge passes them
constexpr int frames = 200;

/// What is compared from picture to picture: the mean luminance of each block relative to the brightest
/// block's, and last the logarithm of the whole picture's. The sun's disc is left out, which goes from pixel
/// to pixel.
std::vector<double> levels(const image::LinearPicture& picture) {
    std::vector<double> sums(std::size_t((width / block) * (height / block)), 0.0);
    double whole = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width / block * block; ++x) {
            if (picture.shows[picture.index(x, y)] == image::Shows::disc) {
                continue;
            }
            const double luminance = double(airlight::luminance(
                airlight::vec3<float>(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2))));
            sums[std::size_t(y / block * (width / block) + x / block)] += luminance;
            whole += luminance / (width * height);
        }
    }
    const double brightest = *std::max_element(sums.begin(), sums.end());
    for (double& sum : sums) {
        sum /= std::max(brightest, 1e-30);  // of a midnight without any light
    }
    sums.push_back(std::log(whole + 1e-9));  // 1e-9: less than a starry night, per sunlight
    return sums;
}

int bad_numbers(const image::LinearPicture& picture) {
    return int(std::count_if(picture.radiance.begin(), picture.radiance.end(),
                             [](float x) { return !(x >= 0 && x < 1e10f); }));
}

/// How far a picture is from where the four around it say that it is, by the cubic through them: of a smooth
/// change nearly nothing, of a step half of it.
struct Jump {
    double size = 0;
    int frame = 0;
    int block = 0;
};

struct Jumps {
    Jump share;  ///< of a block, relative to the brightest
    Jump level;  ///< of the whole picture, in logarithms
};

Jumps jumps_of(const std::vector<std::vector<double>>& all, std::size_t first, std::size_t end) {
    Jumps worst;
    for (std::size_t i = std::max<std::size_t>(first, 2); i < std::min(end, all.size() - 2); ++i) {
        for (std::size_t b = 0; b < all[i].size(); ++b) {
            const double expected = (4 * (all[i - 1][b] + all[i + 1][b]) - all[i - 2][b] - all[i + 2][b]) / 6;
            Jump& jump = b + 1 < all[i].size() ? worst.share : worst.level;
            const double size = std::abs(all[i][b] - expected);
            if (!(size <= jump.size)) {  // so that no number is worst of all
                jump = {size, int(i), int(b)};
            }
        }
    }
    return worst;
}

/// Draws all of them in one renderer: Earth with every fourth height of the landscape, as rugged at this
/// size.
std::vector<std::vector<double>> levels_of(const std::vector<deferred::Moment>& moments) {
    deferred::Settings settings;
    settings.shadow_size = 256;
    image::Studio studio("earth", settings, width, height, 4);
    std::vector<std::vector<double>> all;
    for (const deferred::Moment& moment : moments) {
        const image::LinearPicture picture = studio.draw(moment);
        CAPTURE(all.size());
        CHECK(bad_numbers(picture) == 0);  // no NaN, no infinity, nothing negative
        all.push_back(levels(picture));
    }
    return all;
}

void check(const char* what, const Jumps& jumps, double tolerated_share, double tolerated_level) {
    std::printf(
        "%s: share of a block %.3f off (%.2f) at frame %d, block %d; level %.3f off (%.2f) at frame %d\n",
        what, jumps.share.size, tolerated_share, jumps.share.frame, jumps.share.block, jumps.level.size,
        tolerated_level, jumps.level.frame);
    CHECK(jumps.share.size <= tolerated_share);
    CHECK(jumps.level.size <= tolerated_level);
}

const deferred::Moment start{image::camera_called("ground"), 20, 250};

}  // namespace

// Each picture is 1.1 times as high as the last. Where nothing is smaller than a pixel, things change over a
// factor of e in height, 11 frames, as a sine of half that wavelength: a share that swings by 1 is off by at
// most (pi / 11)^4 / 12 = 6e-4. The rest is edges, of hills or of the limb, which cross the 9 pixels of a
// block's side one by one: two of them at once, out of step with the others, are 2 / 9 of the block, of which
// the cubic misses a quarter.
TEST_CASE("a flight from 1 m to 1e8 m has no jump") {
    const std::vector<std::vector<double>> all = levels_of(deferred::flight(frames, start, 6371e3));
    const std::size_t space = 150;  // 1.1e6 m: from here on coasts, glint and limb are narrower than a pixel
    check("flight below 1e6 m", jumps_of(all, 0, space), 0.07, 0.03);  // a step of 6 % of the whole is seen
    check("flight above", jumps_of(all, space, frames), 0.2, 0.1);     // glint and limb come and go by pixels
}

// The sun moves by 1.46 degrees a picture at its rise. In twilight light grows by a factor of 5, at sunrise
// that stops within three pictures: a bend of 1.5 in the logarithm, of which the cubic misses 1 / 12 to 1
// / 6.
TEST_CASE("a day has no jump") {
    const std::vector<std::vector<double>> all = levels_of(deferred::day(frames, start.camera, 36.3));
    check("day", jumps_of(all, 0, frames), 0.15, 0.15);  // 1.5 / 10
}
