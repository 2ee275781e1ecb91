#include "picture.hpp"

#include <string>

#include "support/files.hpp"
#include "support/image.hpp"
#include "support/rows.hpp"

namespace reference {
namespace {

constexpr int shown_orders = 4;

}  // namespace

void write_picture(const support::Preset& preset, const View& eye, double sun_diameter, int width,
                   const Effort& effort, const std::filesystem::path& path) {
    support::make_writable_directory_of(path);
    const int height = width / 2;
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    support::ExrImage image{width,
                            height,
                            {},
                            {{"units", "1/sr: radiance of the air per solar irradiance above it"},
                             {"atmosphere", preset.name},
                             {"walks", std::to_string(effort.walks)},
                             {"seed", std::to_string(effort.seed)}}};
    const auto add_layer = [&](const std::string& layer) {
        for (const char* channel : {"R", "G", "B"}) {
            image.channels.push_back({layer + channel, std::vector<float>(count)});
        }
    };
    add_layer("");
    add_layer("error.");
    for (int k = 1; k <= shown_orders; ++k) {
        add_layer("order_" + std::to_string(k) + ".");
    }

    const Air airs[3] = {
        {preset.air, preset.ozone, 0}, {preset.air, preset.ozone, 1}, {preset.air, preset.ozone, 2}};
    const support::Rows rows("tracing " + path.filename().string());
    rows(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            View view = eye;
            view.elevation = 90 - (y + 0.5) * 180 / height;
            view.azimuth = (x + 0.5) * 360 / width - 180;
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            Effort own = effort;
            own.seed = effort.seed + 0x9e3779b97f4a7c15ULL * (pixel + 1);
            for (std::size_t c = 0; c < 3; ++c) {
                const Radiance radiance = traced(airs[c], view, sun_diameter, own);
                image.channels[c].pixels[pixel] = static_cast<float>(radiance.total.mean);
                image.channels[3 + c].pixels[pixel] = static_cast<float>(radiance.total.error);
                for (std::size_t k = 0; k < shown_orders; ++k) {
                    image.channels[6 + 3 * k + c].pixels[pixel] = static_cast<float>(radiance.order[k].mean);
                }
            }
        }
    });
    support::write_exr(path, image);
}

}  // namespace reference
