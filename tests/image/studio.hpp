#pragma once

#include <string>
#include <vector>

#include "by_name.hpp"
#include "path.hpp"
#include "renderer.hpp"
#include "settings.hpp"
#include "tables.hpp"
#include "terrain.hpp"
#include "view.hpp"
#include "world.hpp"

// The renderer of examples/deferred with what it needs around it, in one object.

namespace image {

/// What a pixel is of, where the sun's disc and the ground want other rules than the air.
enum class Shows { sky, disc, ground };

/// A picture in linear light, the upper row first.
struct LinearPicture {
    int width;
    int height;
    std::vector<float> radiance;  ///< 3 per pixel, per solar irradiance [1/sr]
    std::vector<Shows> shows;     ///< 1 per pixel

    float at(int x, int y, int channel) const {
        return radiance[3 * index(x, y) + std::size_t(channel)];
    }
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }
};

inline const deferred::Camera& camera_called(const std::string& name) {
    return deferred::by_name(deferred::named_cameras(), name, "camera");
}

/// One world, its tables, its landscape and a renderer of one size. Needs a context. Beside deferred's worlds
/// there are "haze", Earth with 20 times the aerosol, and "black", Earth with ground that reflects nothing.
class Studio {
  public:
    /// Of the height map only every `coarser`-th number is used.
    Studio(const std::string& world, const deferred::Settings& settings, int width, int height,
           int coarser = 1, deferred::TableKind tables = deferred::TableKind::diffuse);

    LinearPicture draw(const deferred::Moment& moment, const deferred::Settings& settings);
    LinearPicture draw(const deferred::Moment& moment) {
        return draw(moment, settings_);
    }

    const std::string& world_name() const {
        return world_name_;
    }

  private:
    std::string world_name_;
    int width_;
    int height_;
    deferred::Settings settings_;
    deferred::World world_;
    deferred::Terrain terrain_;
    deferred::AirTables tables_;
    deferred::Renderer renderer_;
};

}  // namespace image
