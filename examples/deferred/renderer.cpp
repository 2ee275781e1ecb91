#include "renderer.hpp"

#include <chrono>

#include "support/gl_context.hpp"

namespace deferred {

Renderer::Renderer(const World& world, const AirTables& tables, const Terrain& terrain,
                   const Settings& settings, int width, int height)
    : width_(width),
      height_(height),
      atmosphere_block_(Block::atmosphere),
      frame_block_(Block::frame),
      tables_(tables),
      geometry_(world, terrain, settings.objects),
      shadows_(terrain, settings.shadow_size),
      surfaces_(world, width, height),
      stars_(width, height),
      occlusion_(width, height),
      visibility_(width, height, settings.clouds),
      lighting_(world, tables_, width, height),
      shafts_(world, width, height, settings.half_shafts),
      air_(world, tables_, width, height, settings.clouds),
      bloom_(width, height),
      flare_(bloom_),
      tone_(width, height) {
    atmosphere_block_.upload(AtmosphereBlock(world.atmosphere));
    if (settings.clouds) {
        clouds_.emplace(world, tables_, width, height);
    }
    if (has_clip_control()) {
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    support::check_gl("making the render targets");
}

void Renderer::draw(const View& view, const Settings& settings) {
    atmosphere_block_.bind();  // another renderer may have drawn with the same context
    frame_block_.upload(view.frame);
    geometry_.place(view);
    shadows_.draw(view, geometry_, settings.shadows);
    surfaces_.draw(geometry_);
    if (settings.stars) {
        stars_.draw(surfaces_.target());
    }
    if (settings.ambient_occlusion) {
        occlusion_.draw(surfaces_.depth(), surfaces_.normal());
    }
    visibility_.draw(surfaces_, shadows_, settings.ambient_occlusion ? occlusion_.share() : 0);
    glFinish();

    const auto start = std::chrono::steady_clock::now();
    lighting_.draw(surfaces_, visibility_);
    if (clouds_) {
        clouds_->draw(surfaces_);
    }
    any_lost_ = settings.shafts != Shafts::none && settings.shadows && settings.air;
    if (any_lost_) {
        shafts_.draw(surfaces_, shadows_, settings);
    }
    air_.draw(surfaces_, lighting_, any_lost_ ? shafts_.lost() : 0, clouds_);
    glFinish();
    milliseconds_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    support::check_gl("drawing a picture");
}

GpuPicture Renderer::read() const {
    const std::size_t count = std::size_t(width_) * std::size_t(height_);
    GpuPicture picture;
    picture.surfaces.depth = read_texture(surfaces_.depth(), GL_DEPTH_COMPONENT, count);
    picture.surfaces.albedo = read_texture(surfaces_.albedo(), GL_RGBA, 4 * count);
    picture.surfaces.normal = read_texture(surfaces_.normal(), GL_RGBA, 4 * count);
    picture.surfaces.shares = read_texture(visibility_.shares(), GL_RGBA, 4 * count);
    if (any_lost_) {
        picture.surfaces.lost = read_texture(shafts_.lost(), GL_RGB, 3 * count);
    }
    if (clouds_) {
        picture.surfaces.clouds = read_texture(clouds_->light(), GL_RGBA, 4 * count);
        picture.surfaces.cloud_distance = read_texture(clouds_->distance(), GL_RED, count);
    }
    picture.radiance = read_texture(air_.radiance(), GL_RGB, 3 * count);
    picture.milliseconds = milliseconds_;
    support::check_gl("reading a picture");
    return picture;
}

std::vector<std::uint8_t> Renderer::display(const Settings& settings, float exposure) {
    if (settings.bloom || settings.flare) {
        bloom_.reduce(air_.radiance());
    }
    if (settings.bloom) {
        bloom_.spread();
    }
    if (settings.flare) {
        flare_.draw(bloom_);
    }
    tone_.draw(air_.radiance(), visibility_.shares(), bloom_, flare_, settings, exposure);
    std::vector<std::uint8_t> bytes = tone_.read();
    support::check_gl("encoding a picture");
    return bytes;
}

}  // namespace deferred
