#include "picture_files.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace deferred {
namespace {

/// OpenGL's lowest row first becomes the files' top row first. `stride` values a pixel, `channel` of them.
std::vector<float> plane(const std::vector<float>& pixels, int width, int height, int stride, int channel) {
    std::vector<float> values(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t from = std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x);
            values[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
                pixels[from * std::size_t(stride) + std::size_t(channel)];
        }
    }
    return values;
}

}  // namespace

support::Picture upright(const std::vector<std::uint8_t>& pixels, int width, int height) {
    support::Picture picture{width, height, {}};
    picture.pixels.reserve(pixels.size());
    const std::ptrdiff_t row = 3 * std::ptrdiff_t(width);
    for (int y = height - 1; y >= 0; --y) {
        picture.pixels.insert(picture.pixels.end(), pixels.begin() + y * row, pixels.begin() + (y + 1) * row);
    }
    return picture;
}

support::ExrImage layers(const GpuPicture& picture, const Frame& frame) {
    support::ExrImage image{frame.width, frame.height, {}, {}};
    const auto add = [&](const std::string& name, const std::vector<float>& pixels, int stride, int channel) {
        image.channels.push_back({name, plane(pixels, frame.width, frame.height, stride, channel)});
    };
    add("radiance.R", picture.radiance, 3, 0);
    add("radiance.G", picture.radiance, 3, 1);
    add("radiance.B", picture.radiance, 3, 2);
    add("albedo.R", picture.surfaces.albedo, 4, 0);
    add("albedo.G", picture.surfaces.albedo, 4, 1);
    add("albedo.B", picture.surfaces.albedo, 4, 2);
    add("roughness.Y", picture.surfaces.albedo, 4, 3);
    add("normal.X", picture.surfaces.normal, 4, 0);
    add("normal.Y", picture.surfaces.normal, 4, 1);
    add("normal.Z", picture.surfaces.normal, 4, 2);
    if (!picture.surfaces.shares.empty()) {
        add("sunlit.Y", picture.surfaces.shares, 4, 0);
        add("skylit.Y", picture.surfaces.shares, 4, 1);
    }
    if (!picture.surfaces.clouds.empty()) {
        add("clouds.Y", picture.surfaces.clouds, 4, 3);
    }
    add("depth.Z", picture.surfaces.depth, 1, 0);
    // Reversed depth back to a distance; division by 0 gives the infinity it stands for.
    for (float& depth : image.channels.back().pixels) {
        depth = frame.near_distance / depth;
    }
    image.attributes = {
        {"radianceUnits",
         "1/sr: radiance per solar irradiance above the air; linear, not exposed; before bloom and flare"},
        {"depthUnits", "metres along the view axis; infinite where there is no surface"},
        {"normalUnits", "unit vectors; x east, y north, z up at the landscape's centre; 0 without a surface"},
        {"albedoUnits", "1, reflected share of the light; without a surface stars, of magnitude 0 each"},
        {"cloudsUnits", "1, share of the light behind that clouds let through"},
        {"sunlitUnits", "1, share of the sun that nothing hides"},
        {"skylitUnits", "1, share of the sky that nothing hides"},
    };
    return image;
}

float automatic_exposure(const std::vector<float>& radiance, const std::vector<bool>& disc) {
    std::vector<float> lit;
    for (std::size_t i = 0; i < disc.size(); ++i) {
        if (!disc[i]) {
            lit.push_back(
                airlight::luminance(vec3(radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2])));
        }
    }
    std::sort(lit.begin(), lit.end());
    // Space and night are no part of it: a hundredth of what is bright is dark.
    const float bright = lit.empty() ? 0 : lit[std::size_t(0.98 * double(lit.size() - 1))];
    const auto first = std::upper_bound(lit.begin(), lit.end(), 0.01f * bright);
    if (first == lit.end()) {
        return 1;
    }
    const float middle = *(first + (lit.end() - first) / 2);
    // Before a bright sky a dark foreground stays dark: nine tenths of what is lit keep their colour.
    const float high = *(first + 9 * (lit.end() - first) / 10);
    return std::clamp(std::min(0.25f / middle, 1.3f / high), 1e-6f, 1e12f);
}

}  // namespace deferred
