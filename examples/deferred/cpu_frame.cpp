#include "cpu_frame.hpp"

#include <cstddef>

#include "shading.hpp"
#include "support/parallel.hpp"

namespace deferred {
namespace {

template <typename Scene>
std::vector<float> light(const World& world, const AirTables& tables, const Frame& frame,
                         const GBuffer& surfaces) {
    std::vector<float> radiance(3 * std::size_t(frame.width) * std::size_t(frame.height));
    support::for_each_row(frame.height, [&](int y) {
        for (int x = 0; x < frame.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(frame.width) + std::size_t(x);
            const float* const albedo = &surfaces.albedo[4 * i];
            const float* const normal = &surfaces.normal[4 * i];
            const float* const shares = &surfaces.shares[4 * i];
            const float* const lost = surfaces.lost.empty() ? nullptr : &surfaces.lost[3 * i];
            const Surface surface{surfaces.depth[i], vec3(albedo[0], albedo[1], albedo[2]),
                                  albedo[3],         vec3(normal[0], normal[1], normal[2]),
                                  shares[0],         shares[1]};
            Cloud cloud{vec3(0), 1, 0};
            const vec3 behind = light_behind_air<Scene>(world.atmosphere, frame, tables, surface, x, y);
            if (!surfaces.clouds.empty()) {
                const float* const light = &surfaces.clouds[4 * i];
                cloud = Cloud{vec3(light[0], light[1], light[2]), light[3], surfaces.cloud_distance[i]};
            }
            const vec3 pixel = light_through_clouds<Scene>(
                world.atmosphere, frame, tables, surface.depth, behind,
                lost == nullptr ? vec3(0) : vec3(lost[0], lost[1], lost[2]), cloud, x, y);
            radiance[3 * i] = pixel.x;
            radiance[3 * i + 1] = pixel.y;
            radiance[3 * i + 2] = pixel.z;
        }
    });
    return radiance;
}

}  // namespace

std::vector<float> light_on_cpu(const World& world, const AirTables& tables, const Frame& frame,
                                const GBuffer& surfaces) {
    return world.lorentzian_ozone ? light<LorentzianScene>(world, tables, frame, surfaces)
                                  : light<airlight::DefaultScene>(world, tables, frame, surfaces);
}

std::vector<bool> disc_pixels(const Frame& frame, const GBuffer& surfaces) {
    std::vector<bool> disc;
    disc.reserve(surfaces.depth.size());
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const bool surface = surfaces.depth[disc.size()] > 0;
            const vec3 direction = unit(pixel_ray(frame, x, y));
            disc.push_back(!surface &&
                           (sun_disc(frame, direction) != vec3(0) || moon_share(frame, direction) > 0));
        }
    }
    return disc;
}

}  // namespace deferred
