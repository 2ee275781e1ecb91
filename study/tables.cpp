#include "tables.hpp"

#include <baselines/baselines.hpp>

#include "support/parallel.hpp"
#include "support/presets.hpp"
#include "worlds.hpp"

namespace study {
namespace {

using airlight::vec2;
using airlight::vec3;

template <typename Texel>
Texels filled(int width, int height, const Texel& texel) {
    Texels out{width, height, std::vector<vec3<double>>(static_cast<std::size_t>(width * height))};
    support::for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            out.values[static_cast<std::size_t>(y * width + x)] =
                texel(vec2<double>((x + 0.5) / width, (y + 0.5) / height));
        }
    });
    return out;
}

template <typename Make>
std::vector<Texels> for_all_worlds(const Make& make) {
    std::vector<Texels> out;
    for (const World& world : worlds()) {
        out.push_back(support::with_ozone(world.ozone, [&](auto scene) { return make(world.air, scene); }));
    }
    return out;
}

}  // namespace

const Texels& cs562_texels(std::size_t world) {
    static const std::vector<Texels> all = for_all_worlds([](const auto& air, auto scene) {
        return filled(256, 256, [&](const vec2<double>& uv) {
            return airlight::baseline::cs562_texel<double, decltype(scene)>(air, uv, 500);
        });
    });
    return all[world];
}

const Texels& hillaire_texels(std::size_t world) {
    static const std::vector<Texels> all = for_all_worlds([](const auto& air, auto scene) {
        return filled(256, 64, [&](const vec2<double>& uv) {
            return airlight::baseline::hillaire_texel<double, decltype(scene)>(air, uv, 40);
        });
    });
    return all[world];
}

}  // namespace study
