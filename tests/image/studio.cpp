#include "studio.hpp"

#include <stdexcept>

#include "cpu_frame.hpp"

namespace image {
namespace {

deferred::Terrain landscape(int coarser) {
    const deferred::HeightMap map = deferred::read_height_map(DEFERRED_HEIGHT_MAP, 74, 93);
    deferred::HeightMap out{0, 0, map.step_east * coarser, map.step_north * coarser, {}};
    for (int row = 0; row < map.rows; row += coarser) {
        ++out.rows;
        for (int column = 0; column < map.columns; column += coarser) {
            out.heights.push_back(map.heights[std::size_t(row * map.columns + column)]);
        }
    }
    out.columns = int(out.heights.size()) / out.rows;
    return deferred::Terrain(out);
}

deferred::World world_called(const std::string& name) {
    for (const deferred::World& world : deferred::worlds()) {
        if (world.name == name) {
            return world;
        }
    }
    deferred::World earth = deferred::worlds().front();
    if (name == "haze") {
        earth.atmosphere.mie_scattering *= 20.0f;
        earth.atmosphere.mie_absorption *= 20.0f;
    } else if (name == "black") {
        earth.vegetated = false;
        earth.atmosphere.ground_albedo = deferred::vec3(0);
    } else {
        throw std::runtime_error("no world " + name);
    }
    return earth;
}

}  // namespace

Studio::Studio(const std::string& world, const deferred::Settings& settings, int width, int height,
               int coarser, deferred::TableKind tables)
    : world_name_(world),
      width_(width),
      height_(height),
      settings_(settings),
      world_(world_called(world)),
      terrain_(landscape(coarser)),
      tables_(deferred::bake_tables(tables, world_)),
      renderer_(world_, tables_, terrain_, settings_, width, height) {}

LinearPicture Studio::draw(const deferred::Moment& moment, const deferred::Settings& settings) {
    const deferred::Picturing picturing{width_, height_, moment.sun_elevation, moment.sun_azimuth, false, 40,
                                        12,     settings};
    const deferred::View view =
        deferred::make_view(moment.camera, picturing, double(world_.atmosphere.ground_radius), terrain_);
    renderer_.draw(view, settings);
    const deferred::GpuPicture drawn = renderer_.read();
    const std::vector<bool> disc = deferred::disc_pixels(view.frame, drawn.surfaces);

    LinearPicture picture{width_, height_, {}, {}};
    picture.radiance.reserve(drawn.radiance.size());
    for (int y = height_ - 1; y >= 0; --y) {
        for (int x = 0; x < width_; ++x) {
            const std::size_t i = picture.index(x, y);
            picture.radiance.insert(picture.radiance.end(), &drawn.radiance[3 * i],
                                    &drawn.radiance[3 * i] + 3);
            picture.shows.push_back(disc[i]                       ? Shows::disc
                                    : drawn.surfaces.depth[i] > 0 ? Shows::ground
                                                                  : Shows::sky);
        }
    }
    return picture;
}

}  // namespace image
